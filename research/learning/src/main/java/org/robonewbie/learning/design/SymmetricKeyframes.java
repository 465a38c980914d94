package org.robonewbie.learning.design;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Mirror;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;

/**
 * The changes that can be made to a motion in which both sides do the same: the time of each keyframe, and the angles of all but the last
 * one.
 */
final class SymmetricKeyframes {

    private static final double MILLIS_PER_COORDINATE = 80;
    private static final double DEGREES_PER_COORDINATE = 5;
    private static final int CYCLE_MILLIS = 20;
    private static final int SHORTEST_MILLIS = 40;
    private static final List<Joint> LEFT = Arrays.stream(Joint.values())
            .filter(joint -> joint.name().startsWith("LEFT_"))
            .toList();

    private final Motion first;

    SymmetricKeyframes(Motion first) {
        this.first = first;
    }

    /** The number of coordinates. */
    int dimension() {
        return first.keyframes().size() * (1 + LEFT.size()) - LEFT.size();
    }

    /** The motion that belongs to coordinates; with all of them 0 it is the first one. */
    Motion motion(double[] x) {
        List<Keyframe> keyframes = new ArrayList<>();
        int last = first.keyframes().size() - 1;
        for (int i = 0; i <= last; i++) {
            Keyframe before = first.keyframes().get(i);
            int at = i * (1 + LEFT.size());
            keyframes.add(new Keyframe(
                    millis(before.durationMillis(), x[at]),
                    i == last ? before.posture() : posture(before.posture(), x, at + 1)));
        }
        return new Motion(first.name(), keyframes);
    }

    private static int millis(int before, double change) {
        int cycles = (int) Math.round((before + MILLIS_PER_COORDINATE * change) / CYCLE_MILLIS);
        return Math.max(SHORTEST_MILLIS, cycles * CYCLE_MILLIS);
    }

    private static Posture posture(Posture before, double[] x, int at) {
        double[] degrees = before.toArray();
        for (int i = 0; i < LEFT.size(); i++) {
            Joint joint = LEFT.get(i);
            double wanted = joint.clampDegrees(before.degrees(joint) + DEGREES_PER_COORDINATE * x[at + i]);
            double angle = Math.round(10 * wanted) / 10.0;
            degrees[joint.ordinal()] = angle;
            degrees[Mirror.partner(joint).ordinal()] = Mirror.mirroredDegrees(joint, angle);
        }
        return Posture.of(degrees);
    }
}
