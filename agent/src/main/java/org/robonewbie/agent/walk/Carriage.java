package org.robonewbie.agent.walk;

/** How the torso is carried: what changes slowly, from one step to the next. */
public final class Carriage {

    private double vigour;
    private double leanDegrees;
    private double feetForward;

    /** Creates a carriage that is upright and still. */
    Carriage() {}

    /**
     * Carries the torso as a gait does.
     *
     * @param gait the gait
     * @param vigour 1 sways and lifts as the gait says, 0 not at all
     * @return the carriage
     */
    public static Carriage of(Gait gait, double vigour) {
        Carriage carriage = new Carriage();
        carriage.set(vigour, gait.leanDegrees(), gait.feetForward());
        return carriage;
    }

    /** 1 sways and lifts as the gait says, 0 not at all. */
    double vigour() {
        return vigour;
    }

    /** How much the torso bows forward. */
    double leanDegrees() {
        return leanDegrees;
    }

    /** How far the ankles stand ahead of the hips, metres. */
    double feetForward() {
        return feetForward;
    }

    void set(double newVigour, double newLeanDegrees, double newFeetForward) {
        vigour = newVigour;
        leanDegrees = newLeanDegrees;
        feetForward = newFeetForward;
    }

    void set(Carriage other) {
        set(other.vigour, other.leanDegrees, other.feetForward);
    }

    /** Takes the carriage on the way from one to another. */
    void setBetween(Carriage from, Carriage to, double fraction) {
        set(
                from.vigour + fraction * (to.vigour - from.vigour),
                from.leanDegrees + fraction * (to.leanDegrees - from.leanDegrees),
                from.feetForward + fraction * (to.feetForward - from.feetForward));
    }
}
