package org.robonewbie.agent.walk;

import org.robonewbie.nao.Joint;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.nao.kinematics.InverseKinematics;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.motion.Posture;

/**
 * One step: the swing foot moves to its target while the support foot stays in place. The torso moves to the midpoint
 * between the feet and sways over the support foot. Inverse kinematics yields the joint angles of the legs.
 *
 * @param gait parameters of the gait
 * @param swing the swing leg
 * @param start pose of the swing foot at the beginning
 * @param target pose of the swing foot at the end
 * @param support pose of the support foot
 * @param before posture of the torso at the beginning
 * @param after posture of the torso at the end
 */
public record Step(
        Gait gait, Leg swing, Pose2d start, Pose2d target, Pose2d support, TorsoPosture before, TorsoPosture after) {

    private static final double ANKLE_BEHIND_TORSO = 0.005;
    private static final double MAX_ARM_DEGREES = 45;

    StepPhase at(double phase) {
        return new StepPhase(gait, swing, phase, before.towards(after, phase));
    }

    /** Computes a corrected posture; the numerical inverse kinematics starts from the previous posture. */
    Posture posture(InverseKinematics kinematics, Posture previous, StepPhase moment, Correction correction) {
        Pose2d middle = start.interpolate(target, moment.phase()).interpolate(support, 0.5);
        Pose2d foot = swingFoot(moment, correction);
        FootPose swingPose = pose(foot, middle, swing, moment).raised(moment.lift(), moment.toeDegrees());
        FootPose supportPose = pose(support, middle, swing.other(), moment);
        Posture legs = moment.legs(
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

    /**
     * Returns the pose of the swing foot on the ground plane; at the end of the step, the pose in which it is set down.
     */
    Pose2d swingFoot(StepPhase moment, Correction correction) {
        double travelled = moment.travelled();
        return start.interpolate(target, travelled)
                .then(correction.swingForward() * travelled, correction.swingLeft() * travelled, 0);
    }

    /**
     * Returns the pose of a standing foot relative to the torso, which is above the midpoint between the feet, apart
     * from sway and offsets.
     */
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

    /** Swings each arm opposite to the leg on its side. The stride is the distance of the swing foot ahead of the support foot. */
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
