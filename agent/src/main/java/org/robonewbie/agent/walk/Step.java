package org.robonewbie.agent.walk;

import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.InverseKinematics;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.motion.Posture;

/**
 * One step: a foot swings to its new place while the other one stands, and the torso moves on evenly to the middle between both
 * feet and sways to the side of the standing leg; inverse kinematics gives the angles.
 *
 * <pre>{@code
 * Step step = new Step(gait, Leg.LEFT, FootPlace.LEFT, FootPlace.RIGHT, FootPlace.LEFT.moved(0.05, 0), carriage, carriage);
 * Posture halfWay = step.posture(kinematics, 0.5, Correction.NONE);
 * }</pre>
 *
 * @param gait how the robot steps
 * @param leg which leg swings
 * @param start where its foot stood
 * @param target where its foot is set down
 * @param support where the other foot stands
 * @param before how the torso is carried at the beginning
 * @param after how the torso is carried at the end
 */
public record Step(
        Gait gait, Leg leg, FootPlace start, FootPlace target, FootPlace support, Carriage before, Carriage after) {

    private static final double ANKLE_BEHIND_TORSO = 0.005;
    private static final double MOST_ARM_DEGREES = 45;

    /**
     * Calculates a posture of this step.
     *
     * @param kinematics the robot's
     * @param time which part of the step is over, 0 to 1
     * @param correction what the sense of balance changes
     * @return the posture
     */
    public Posture posture(InverseKinematics kinematics, double time, Correction correction) {
        return posture(kinematics, Stance.POSTURE, time, correction);
    }

    /** The same, while the search for the angles begins with a posture that is near. */
    Posture posture(InverseKinematics kinematics, Posture near, double time, Correction correction) {
        Carriage carriage = before.towards(after, time);
        StepMoment moment = new StepMoment(gait, leg, time, carriage.vigour());
        FootPlace swinging = swinging(moment, correction);
        FootPlace middle = start.towards(support, 0.5).towards(target.towards(support, 0.5), time);
        TorsoPose torso =
                new TorsoPose(gait.torsoHeight() + moment.bounce(), carriage.leanDegrees(), moment.rollDegrees());
        FootPose swung = foot(leg, swinging, middle, carriage, moment, true);
        FootPose standing = foot(leg.other(), support, middle, carriage, moment, false);
        Posture arms = armsSwinging(
                near, swinging.seenFrom(middle).x() - support.seenFrom(middle).x());
        Posture posture = leg == Leg.LEFT
                ? torso.above(kinematics, arms, swung, standing)
                : torso.above(kinematics, arms, standing, swung);
        return corrected(moment.withLiftedHip(posture), correction);
    }

    /**
     * Tells how the torso leans at a moment, as planned.
     *
     * @param time which part of the step is over, 0 to 1
     * @return degrees to the right
     */
    public double rollDegrees(double time) {
        return new StepMoment(gait, leg, time, before.towards(after, time).vigour()).rollDegrees();
    }

    /**
     * Tells where the swinging foot is set down.
     *
     * @param correction what the sense of balance changes
     * @return the place
     */
    public FootPlace landing(Correction correction) {
        return swinging(new StepMoment(gait, leg, 1, after.vigour()), correction);
    }

    private FootPlace swinging(StepMoment moment, Correction correction) {
        double travelled = moment.travelled();
        return start.towards(target, travelled)
                .then(correction.swingForward() * travelled, correction.swingLeft() * travelled, 0);
    }

    private FootPose foot(
            Leg which, FootPlace place, FootPlace middle, Carriage carriage, StepMoment moment, boolean swings) {
        Vector3 seen = place.seenFrom(middle);
        double outward = which == Leg.LEFT ? gait.feetApart() : -gait.feetApart();
        return new FootPose(
                seen.x() + carriage.feetForward() - ANKLE_BEHIND_TORSO,
                seen.y() + outward - moment.sway(),
                swings ? moment.lift() : 0,
                place.yawDegrees() - middle.yawDegrees(),
                swings ? moment.toeDegrees() : 0);
    }

    private Posture armsSwinging(Posture posture, double metres) {
        double leftAhead = leg == Leg.LEFT ? metres : -metres;
        double swing = Math.max(-MOST_ARM_DEGREES, Math.min(MOST_ARM_DEGREES, gait.armSwing() * leftAhead));
        Posture stance = Stance.POSTURE;
        return posture.with(Joint.LEFT_SHOULDER_PITCH, stance.degrees(Joint.LEFT_SHOULDER_PITCH) - swing)
                .with(Joint.RIGHT_SHOULDER_PITCH, stance.degrees(Joint.RIGHT_SHOULDER_PITCH) + swing);
    }

    private static Posture corrected(Posture posture, Correction correction) {
        double[] degrees = posture.toArray();
        degrees[Joint.LEFT_FOOT_PITCH.ordinal()] += correction.anklePitchDegrees();
        degrees[Joint.RIGHT_FOOT_PITCH.ordinal()] += correction.anklePitchDegrees();
        degrees[Joint.LEFT_HIP_PITCH.ordinal()] += correction.hipPitchDegrees();
        degrees[Joint.RIGHT_HIP_PITCH.ordinal()] += correction.hipPitchDegrees();
        degrees[Joint.LEFT_FOOT_ROLL.ordinal()] += correction.ankleRollDegrees();
        degrees[Joint.RIGHT_FOOT_ROLL.ordinal()] += correction.ankleRollDegrees();
        degrees[Joint.LEFT_HIP_ROLL.ordinal()] += correction.hipRollDegrees();
        degrees[Joint.RIGHT_HIP_ROLL.ordinal()] += correction.hipRollDegrees();
        return Posture.of(degrees).clamped();
    }
}
