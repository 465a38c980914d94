package org.robonewbie.learning.design;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.BallPlace;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;

/**
 * The changes that can be made to a kick: the time of each keyframe but the last one, the angles of the legs and shoulders in it, and, with
 * the last two coordinates, the place of the ball.
 */
final class KickKeyframes {

    private static final double MILLIS_PER_COORDINATE = 30;
    private static final double DEGREES_PER_COORDINATE = 5;
    private static final double METRES_PER_COORDINATE = 0.01;
    private static final double MARGIN_DEGREES = 0.5;
    private static final int CYCLE_MILLIS = 20;
    private static final int SHORTEST_MILLIS = 40;
    private static final List<Joint> JOINTS = Arrays.stream(Joint.values())
            .filter(joint -> !joint.name().startsWith("NECK_") && !joint.name().contains("_ARM_"))
            .toList();

    private final Motion first;
    private final BallPlace ball;

    KickKeyframes(Motion first, BallPlace ball) {
        this.first = first;
        this.ball = ball;
    }

    private int changedKeyframes() {
        return first.keyframes().size() - 1;
    }

    /** The number of coordinates. */
    int dimension() {
        return changedKeyframes() * (1 + JOINTS.size()) + 2;
    }

    /** The kick that belongs to coordinates; with all of them 0 it is the first one. */
    Motion motion(double[] x) {
        List<Keyframe> keyframes = new ArrayList<>();
        for (int i = 0; i < changedKeyframes(); i++) {
            Keyframe before = first.keyframes().get(i);
            int at = i * (1 + JOINTS.size());
            keyframes.add(new Keyframe(millis(before.durationMillis(), x[at]), posture(before.posture(), x, at + 1)));
        }
        keyframes.add(first.keyframes().get(changedKeyframes()));
        return new Motion(first.name(), keyframes);
    }

    /** The place of the ball that belongs to coordinates, in whole millimetres. */
    BallPlace ball(double[] x) {
        return rounded(
                ball.ahead() + METRES_PER_COORDINATE * x[x.length - 2],
                ball.left() + METRES_PER_COORDINATE * x[x.length - 1]);
    }

    /** A place in whole millimetres. */
    static BallPlace rounded(double ahead, double left) {
        return new BallPlace(Math.round(1000 * ahead) / 1000.0, Math.round(1000 * left) / 1000.0);
    }

    private static int millis(int before, double change) {
        int cycles = (int) Math.round(MILLIS_PER_COORDINATE * change / CYCLE_MILLIS);
        return cycles == 0 ? before : Math.max(SHORTEST_MILLIS, before + cycles * CYCLE_MILLIS);
    }

    private static Posture posture(Posture before, double[] x, int at) {
        Posture posture = before;
        for (int i = 0; i < JOINTS.size(); i++) {
            Joint joint = JOINTS.get(i);
            double degrees = before.degrees(joint);
            double low = Math.min(degrees, joint.minDegrees() + MARGIN_DEGREES);
            double high = Math.max(degrees, joint.maxDegrees() - MARGIN_DEGREES);
            double wanted = Math.max(low, Math.min(high, degrees + DEGREES_PER_COORDINATE * x[at + i]));
            posture = posture.with(joint, Math.round(10 * wanted) / 10.0);
        }
        return posture;
    }
}
