package org.robonewbie.agent.walk;

/**
 * How the torso is carried: what changes slowly, from one step to the next.
 *
 * @param vigour 1 sways and lifts as the gait says, 0 not at all
 * @param leanDegrees how much the torso bows forward
 * @param feetForward how far the ankles stand ahead of the hips, metres
 */
public record Carriage(double vigour, double leanDegrees, double feetForward) {

    /**
     * Carries the torso as a gait does.
     *
     * @param gait the gait
     * @param vigour 1 sways and lifts as the gait says, 0 not at all
     * @return the carriage
     */
    public static Carriage of(Gait gait, double vigour) {
        return new Carriage(vigour, gait.leanDegrees(), gait.feetForward());
    }

    /** The carriage on the way to another one. */
    Carriage towards(Carriage other, double fraction) {
        return new Carriage(
                vigour + fraction * (other.vigour - vigour),
                leanDegrees + fraction * (other.leanDegrees - leanDegrees),
                feetForward + fraction * (other.feetForward - feetForward));
    }
}
