package org.robonewbie.learning.optimise;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Mirror;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;

/**
 * Search space for a motion: changes to the duration of each keyframe and to its joint angles, except those of the
 * head. A posture that is its own mirror image stays symmetric, and so does a walk whose second half mirrors its first.
 * In all other motions, the last keyframe is fixed, because the next motion begins there.
 */
final class KeyframeSpace {

    private static final double MILLIS_PER_COORDINATE = 60;
    private static final double DEGREES_PER_COORDINATE = 5;
    private static final int CYCLE_MILLIS = 20;
    private static final int MIN_MILLIS = 40;
    private static final double MARGIN_DEGREES = 0.5;

    private final Motion motion;
    private final boolean alternating;
    private final List<List<Joint>> joints = new ArrayList<>();

    KeyframeSpace(Motion motion) {
        this.motion = motion;
        List<Keyframe> keyframes = motion.keyframes();
        this.alternating = isAlternating(keyframes);
        int changed = alternating ? keyframes.size() / 2 : keyframes.size() - 1;
        for (Keyframe keyframe : keyframes.subList(0, Math.max(0, changed))) {
            boolean symmetric = isSymmetric(keyframe.posture());
            joints.add(List.of(Joint.values()).stream()
                    .filter(joint -> !joint.name().startsWith("NECK_"))
                    .filter(joint -> !symmetric || joint.name().startsWith("LEFT_"))
                    .toList());
        }
    }

    int dimension() {
        return joints.size() + joints.stream().mapToInt(List::size).sum();
    }

    /** Returns the motion at a point in the space; the origin is the original motion. */
    Motion motion(double[] coordinates) {
        List<Keyframe> keyframes = new ArrayList<>(motion.keyframes());
        int at = 0;
        for (int i = 0; i < joints.size(); i++) {
            Keyframe before = keyframes.get(i);
            int millis = millis(before.durationMillis(), coordinates[at++]);
            double[] degrees = before.posture().toArray();
            boolean symmetric = isSymmetric(before.posture());
            for (Joint joint : joints.get(i)) {
                double angle = degrees(joint, degrees[joint.ordinal()], coordinates[at++]);
                degrees[joint.ordinal()] = angle;
                if (symmetric) {
                    degrees[Mirror.partner(joint).ordinal()] = Mirror.mirroredDegrees(joint, angle);
                }
            }
            Keyframe changed = new Keyframe(millis, Posture.of(degrees));
            keyframes.set(i, changed);
            if (alternating) {
                keyframes.set(
                        i + joints.size(),
                        new Keyframe(millis, changed.posture().mirrored()));
            }
        }
        return new Motion(motion.name(), keyframes);
    }

    /** Returns the parameters of the motion at a point in the space. */
    List<Parameter> numbers(double[] coordinates) {
        List<Keyframe> keyframes = motion(coordinates).keyframes();
        List<Parameter> numbers = new ArrayList<>();
        for (int i = 0; i < joints.size(); i++) {
            Keyframe keyframe = keyframes.get(i);
            String place = "keyframe " + (i + 1) + ", ";
            numbers.add(new Parameter(place + "time", "ms", keyframe.durationMillis(), MILLIS_PER_COORDINATE));
            for (Joint joint : joints.get(i)) {
                double degrees = keyframe.posture().degrees(joint);
                String name = joint.name().toLowerCase(Locale.ROOT).replace('_', ' ');
                numbers.add(new Parameter(place + name, "degrees", degrees, DEGREES_PER_COORDINATE));
            }
        }
        return numbers;
    }

    private static int millis(int before, double change) {
        int cycles = (int) Math.round(MILLIS_PER_COORDINATE * change / CYCLE_MILLIS);
        return cycles == 0 ? before : Math.max(MIN_MILLIS, before + cycles * CYCLE_MILLIS);
    }

    private static double degrees(Joint joint, double before, double change) {
        double low = Math.min(before, joint.minDegrees() + MARGIN_DEGREES);
        double high = Math.max(before, joint.maxDegrees() - MARGIN_DEGREES);
        double wanted = Math.max(low, Math.min(high, before + DEGREES_PER_COORDINATE * change));
        return Math.abs(wanted - before) < 0.05 ? before : Math.round(wanted * 10) / 10.0;
    }

    private static boolean isSymmetric(Posture posture) {
        return posture.equals(posture.mirrored());
    }

    private static boolean isAlternating(List<Keyframe> keyframes) {
        int half = keyframes.size() / 2;
        return half > 0
                && keyframes.size() % 2 == 0
                && IntStream.range(0, half).allMatch(i -> isMirrored(keyframes.get(i), keyframes.get(i + half)));
    }

    private static boolean isMirrored(Keyframe one, Keyframe other) {
        return one.durationMillis() == other.durationMillis()
                && one.posture().mirrored().equals(other.posture());
    }
}
