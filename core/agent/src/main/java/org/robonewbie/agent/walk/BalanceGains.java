package org.robonewbie.agent.walk;

/**
 * How strongly a walk answers when the torso leans otherwise than planned: six proportional-derivative controllers. Each gives
 *
 * <pre>
 * correction = perDegree · (tilt − planned tilt) + perDegreePerSecond · rate of tilting
 * </pre>
 *
 * <p>Ankle and hip turn the torso back (the <em>ankle strategy</em> and the <em>hip strategy</em> of human balance); the step
 * puts the swing foot down further to the side to which the robot falls. Angles answer in degrees, steps in metres.
 *
 * @param anklePitch ankle against bending forward
 * @param hipPitch hip against bending forward
 * @param ankleRoll ankle against leaning to the right
 * @param hipRoll hip against leaning to the right
 * @param stepForward step against bending forward
 * @param stepRight step against leaning to the right
 */
public record BalanceGains(
        Gain anklePitch, Gain hipPitch, Gain ankleRoll, Gain hipRoll, Gain stepForward, Gain stepRight) {

    /**
     * One proportional-derivative controller.
     *
     * @param perDegree answer to each degree of tilt beyond the plan
     * @param perDegreePerSecond answer to each degree per second of tilting
     */
    public record Gain(double perDegree, double perDegreePerSecond) {

        double answer(double errorDegrees, double degreesPerSecond) {
            return perDegree * errorDegrees + perDegreePerSecond * degreesPerSecond;
        }
    }

    /** The corrections against a tilt forward and to the right. */
    Correction correction(double pitchError, double pitchRate, double rollError, double rollRate) {
        return new Correction(
                anklePitch.answer(pitchError, pitchRate),
                hipPitch.answer(pitchError, pitchRate),
                ankleRoll.answer(rollError, rollRate),
                hipRoll.answer(rollError, rollRate),
                stepForward.answer(pitchError, pitchRate),
                -stepRight.answer(rollError, rollRate));
    }
}
