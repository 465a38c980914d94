package org.robonewbie.agent.walk;

import org.robonewbie.nao.Joint;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.nao.kinematics.InverseKinematics;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.motion.Posture;

/**
 * One step: the swing foot moves to its new place while the support foot stands, and the torso moves on evenly to the middle
 * between both feet and sways over the support foot. Inverse kinematics gives the angles of the legs.
 *
 * <pre>{@code
 * TorsoPosture torso = TorsoPosture.of(gait, 1);
 * Step step = new Step(gait, Leg.LEFT, Stance.LEFT_FOOT, Stance.LEFT_FOOT.then(0.05, 0, 0), Stance.RIGHT_FOOT, torso, torso);
 * Posture halfWay = step.posture(kinematics, 0.5);
 * }</pre>
 *
 * @param gait how the robot steps
 * @param swing which leg swings
 * @param start where the swing foot stood
 * @param target where the swing foot is set down
 * @param support where the support foot stands
 * @param before how the torso is carried at the beginning
 * @param after how the torso is carried at the end
 */
public record Step(
        Gait gait, Leg swing, Pose2d start, Pose2d target, Pose2d support, TorsoPosture before, TorsoPosture after) {

    private static final double ANKLE_BEHIND_TORSO = 0.005;
    private static final double MAX_ARM_DEGREES = 45;

    /**
     * Calculates a posture of this step, without any correction.
     *
     * @param kinematics the robot's
     * @param phase which part of the step is over, 0 to 1
     * @return the posture
     */
    public Posture posture(InverseKinematics kinematics, double phase) {
        return posture(kinematics, Stance.POSTURE, at(phase), Correction.NONE);
    }

    /** A moment of this step, 0 to 1. */
    StepPhase at(double phase) {
        return new StepPhase(gait, swing, phase, before.towards(after, phase));
    }

    /** Calculates a corrected posture; the search for the legs' angles begins with the posture before. */
    Posture posture(InverseKinematics kinematics, Posture previous, StepPhase moment, Correction correction) {
        Pose2d middle = start.interpolate(target, moment.phase()).interpolate(support, 0.5);
        Pose2d foot = swingFoot(moment, correction);
        FootPose swingPose = pose(foot, middle, swing, moment).raised(moment.lift(), moment.toeDegrees());
        FootPose supportPose = pose(support, middle, swing.other(), moment);
        Posture legs = moment.torsoPose()
                .above(
                        kinematics,
                        previous,
                        swing == Leg.LEFT ? swingPose : supportPose,
                        swing == Leg.LEFT ? supportPose : swingPose);
        double[] degrees = legs.toArray();
        swingArms(
                degrees,
                foot.translation().seenFrom(middle).x()
                        - support.translation().seenFrom(middle).x());
        degrees[hipRoll().ordinal()] += moment.hipRollDegrees();
        correction.addTo(degrees);
        return Posture.of(degrees);
    }

    /** Where the swing foot is, seen from above; at the end of the step the place where it was set down. */
    Pose2d swingFoot(StepPhase moment, Correction correction) {
        double travelled = moment.travelled();
        return start.interpolate(target, travelled)
                .then(correction.swingForward() * travelled, correction.swingLeft() * travelled, 0);
    }

    /** Where a foot on the ground is below the torso, which is above the middle between the feet but for sway and offsets. */
    private FootPose pose(Pose2d foot, Pose2d middle, Leg leg, StepPhase moment) {
        Translation2d seen = foot.translation().seenFrom(middle);
        double outward = leg == Leg.LEFT ? gait.footSpread() : -gait.footSpread();
        return new FootPose(
                seen.x() + moment.torso().ankleOffset() - ANKLE_BEHIND_TORSO,
                seen.y() + outward - moment.sway(),
                0,
                foot.degrees() - middle.degrees(),
                0);
    }

    /** Swings each arm against the leg on its side; the stride is how far the swing foot is ahead of the support foot. */
    private void swingArms(double[] degrees, double stride) {
        double leftAhead = swing == Leg.LEFT ? stride : -stride;
        double angle = Math.max(-MAX_ARM_DEGREES, Math.min(MAX_ARM_DEGREES, gait.armSwing() * leftAhead));
        Posture stance = Stance.POSTURE;
        degrees[Joint.LEFT_SHOULDER_PITCH.ordinal()] = stance.degrees(Joint.LEFT_SHOULDER_PITCH) - angle;
        degrees[Joint.RIGHT_SHOULDER_PITCH.ordinal()] = stance.degrees(Joint.RIGHT_SHOULDER_PITCH) + angle;
    }

    private Joint hipRoll() {
        return swing == Leg.LEFT ? Joint.LEFT_HIP_ROLL : Joint.RIGHT_HIP_ROLL;
    }
}
