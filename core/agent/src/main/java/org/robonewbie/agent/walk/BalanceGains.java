package org.robonewbie.agent.walk;

/**
 * Gains of the balance control: six proportional-derivative controllers, which react to a deviation of the torso's tilt from
 * the plan. Each computes
 *
 * <pre>
 * correction = perDegree · (tilt − planned tilt) + perDegreePerSecond · rate of tilting
 * </pre>
 *
 * <p>The ankle and hip controllers rotate the torso back (the <em>ankle strategy</em> and the <em>hip strategy</em> of
 * human balance); the step controllers move the target of the swing foot in the direction in which the robot is
 * falling. Outputs are degrees for joints and metres for steps.
 *
 * @param anklePitch gain of the ankle correction for forward tilt
 * @param hipPitch gain of the hip correction for forward tilt
 * @param ankleRoll gain of the ankle correction for tilt to the right
 * @param hipRoll gain of the hip correction for tilt to the right
 * @param stepForward gain of the step correction for forward tilt
 * @param stepRight gain of the step correction for tilt to the right
 */
public record BalanceGains(
        Gain anklePitch, Gain hipPitch, Gain ankleRoll, Gain hipRoll, Gain stepForward, Gain stepRight) {

    /**
     * A proportional-derivative controller.
     *
     * @param perDegree output per degree by which the tilt exceeds the planned tilt
     * @param perDegreePerSecond output per degree per second of tilt rate
     */
    public record Gain(double perDegree, double perDegreePerSecond) {

        double output(double errorDegrees, double degreesPerSecond) {
            return perDegree * errorDegrees + perDegreePerSecond * degreesPerSecond;
        }
    }

    Correction correction(WalkMoment moment) {
        return new Correction(
                anklePitch.output(moment.pitchError(), moment.pitchRate()),
                hipPitch.output(moment.pitchError(), moment.pitchRate()),
                ankleRoll.output(moment.rollError(), moment.rollRate()),
                hipRoll.output(moment.rollError(), moment.rollRate()),
                stepForward.output(moment.pitchError(), moment.pitchRate()),
                -stepRight.output(moment.rollError(), moment.rollRate()));
    }
}
