package org.robonewbie.learning.design;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.robonewbie.agent.walk.FootPose;
import org.robonewbie.agent.walk.Stance;
import org.robonewbie.agent.walk.TorsoPose;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;

/**
 * A short dance on the spot: the feet stay where they are, and inverse kinematics finds the legs for what the hips do. Each beat
 * begins and ends softly.
 */
public final class DanceDesign extends DrawnDesign {

    private static final int BEAT_MILLIS = 560;
    private static final int SLOW_BEAT_MILLIS = 800;
    private static final int KEYFRAMES_PER_BEAT = 4;
    private static final double HIGH = 0.345;
    private static final double LOW = 0.305;
    private static final double LEAN_DEGREES = 4;
    private static final double FEET_AHEAD = -0.005;

    /** How an arm is held: shoulder pitch, opening, turn of the forearm and bend of the elbow, in degrees, as for the left arm. */
    private record Arm(double pitch, double open, double turn, double bend) {}

    /** What the body does in one beat: hips to the left, torso height, twist to the left, arms, head to the left and up. */
    private record Beat(double left, double height, double twist, Arm leftArm, Arm rightArm, double look, double nod) {}

    private static final Arm RAISED = new Arm(60, 25, 0, -20);
    private static final Arm ON_HIP = new Arm(-70, 45, 0, -85);
    private static final Arm FORWARD = new Arm(0, 10, 0, -10);
    private static final Arm WIDE = new Arm(10, 85, 0, -10);
    private static final Arm FOLDED = new Arm(-30, 20, -90, -85);

    private static final List<Beat> BEATS = List.of(
            new Beat(0.03, HIGH, 0, RAISED, ON_HIP, 25, 15),
            new Beat(-0.03, HIGH, 0, ON_HIP, RAISED, -25, 15),
            new Beat(0.03, HIGH, 0, RAISED, ON_HIP, 25, 15),
            new Beat(-0.03, HIGH, 0, ON_HIP, RAISED, -25, 15),
            new Beat(0, LOW, 0, FORWARD, FORWARD, 0, -15),
            new Beat(0, HIGH, 0, WIDE, WIDE, 0, 10),
            new Beat(0, LOW, 0, FORWARD, FORWARD, 0, -15),
            new Beat(0, HIGH, 0, RAISED, RAISED, 0, 20),
            new Beat(0.01, LOW + 0.02, 18, FOLDED, WIDE, -20, 0),
            new Beat(-0.01, LOW + 0.02, -18, WIDE, FOLDED, 20, 0),
            new Beat(0.01, LOW + 0.02, 18, FOLDED, WIDE, -20, 0),
            new Beat(-0.01, LOW + 0.02, -18, WIDE, FOLDED, 20, 0),
            new Beat(0.03, HIGH, 0, WIDE, ON_HIP, 20, 0),
            new Beat(-0.03, HIGH, 0, ON_HIP, WIDE, -20, 0),
            new Beat(0, LOW, 0, FOLDED, FOLDED, 0, -20),
            new Beat(0, HIGH, 0, RAISED, RAISED, 0, 25));

    /** Describes the dance. */
    public DanceDesign() {}

    @Override
    List<DescribedMotion> motions() {
        List<Keyframe> keyframes = new ArrayList<>();
        Posture before = Stance.POSTURE;
        for (Beat beat : BEATS) {
            Posture posture = posture(beat);
            keyframes.addAll(softly(before, posture, keyframes.isEmpty() ? SLOW_BEAT_MILLIS : BEAT_MILLIS));
            before = posture;
        }
        keyframes.addAll(softly(before, Stance.POSTURE, SLOW_BEAT_MILLIS));
        return List.of(new DescribedMotion(new Motion("dance", keyframes), "dances on the spot", "stance", "stance"));
    }

    private static List<Keyframe> softly(Posture from, Posture to, int millis) {
        return IntStream.rangeClosed(1, KEYFRAMES_PER_BEAT)
                .mapToObj(i -> new Keyframe(
                        millis / KEYFRAMES_PER_BEAT,
                        Costs.rounded(between(from, to, smooth((double) i / KEYFRAMES_PER_BEAT)))))
                .toList();
    }

    private static double smooth(double part) {
        return part * part * (3 - 2 * part);
    }

    private static Posture between(Posture from, Posture to, double part) {
        double[] degrees = from.toArray();
        for (Joint joint : Joint.values()) {
            degrees[joint.ordinal()] += part * (to.degrees(joint) - from.degrees(joint));
        }
        return Posture.of(degrees);
    }

    private static Posture posture(Beat beat) {
        Posture left = withLeftArm(Stance.POSTURE, beat.leftArm());
        Posture both = withLeftArm(left.mirrored(), beat.rightArm()).mirrored();
        Posture upper = both.with(Joint.NECK_YAW, beat.look()).with(Joint.NECK_PITCH, beat.nod());
        TorsoPose torso = new TorsoPose(beat.height(), LEAN_DEGREES, 0);
        return Costs.rounded(
                torso.above(Costs.kinematics(), upper, foot(beat, Stance.LEFT_FOOT), foot(beat, Stance.RIGHT_FOOT)));
    }

    private static Posture withLeftArm(Posture posture, Arm arm) {
        return posture.with(Joint.LEFT_SHOULDER_PITCH, arm.pitch())
                .with(Joint.LEFT_SHOULDER_YAW, arm.open())
                .with(Joint.LEFT_ARM_ROLL, arm.turn())
                .with(Joint.LEFT_ARM_YAW, arm.bend());
    }

    /** The feet stand still, so they go the other way as seen from the hips. */
    private static FootPose foot(Beat beat, Pose2d place) {
        Pose2d hips = new Pose2d(0, beat.left(), beat.twist());
        Translation2d seen = place.translation().seenFrom(hips);
        return new FootPose(seen.x() + FEET_AHEAD, seen.y(), 0, place.degrees() - beat.twist(), 0);
    }
}
