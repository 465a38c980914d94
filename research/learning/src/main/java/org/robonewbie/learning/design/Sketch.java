package org.robonewbie.learning.design;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Predicate;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Mirror;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.Posture;

/**
 * A motion drawn by hand as the first guess of a search: durations and angles are its coordinates, in units of 0.1 s and 10°. A
 * keyframe that is its own mirror image remains so. The last keyframe does not change.
 */
public final class Sketch {

    private static final double MILLIS_PER_COORDINATE = 100;
    private static final double DEGREES_PER_COORDINATE = 10;
    private static final int SHORTEST_MILLIS = 100;
    private static final int LONGEST_MILLIS = 1500;
    private static final double MARGIN_DEGREES = 0.5;

    private final Motion motion;
    private final List<List<Joint>> joints = new ArrayList<>();

    private Sketch(Motion motion, Predicate<Joint> searched) {
        this.motion = motion;
        List<Keyframe> keyframes = motion.keyframes();
        for (Keyframe keyframe : keyframes.subList(0, keyframes.size() - 1)) {
            boolean symmetric = keyframe.posture().equals(keyframe.posture().mirrored());
            joints.add(Arrays.stream(Joint.values())
                    .filter(searched)
                    .filter(joint -> !symmetric || joint.name().startsWith("LEFT_"))
                    .toList());
        }
    }

    /**
     * Loads a sketch.
     *
     * @param name name of the motion
     * @param searched which joints are searched for; the others stay as they are drawn
     * @return the sketch
     */
    public static Sketch load(String name, Predicate<Joint> searched) {
        try (InputStream stream = Sketch.class.getResourceAsStream("/sketches/" + name + ".txt")) {
            if (stream == null) {
                throw new IllegalArgumentException("There is no sketch \"" + name + "\".");
            }
            return new Sketch(
                    MotionFile.parse(name + ".txt", stream.readAllBytes()).motion(), searched);
        } catch (IOException e) {
            throw new UncheckedIOException("Cannot read the sketch " + name + ".", e);
        }
    }

    /** {@return the coordinates of the sketch as drawn: for each keyframe but the last its duration and its angles} */
    public double[] coordinates() {
        List<Double> all = new ArrayList<>();
        for (int i = 0; i < joints.size(); i++) {
            Keyframe keyframe = motion.keyframes().get(i);
            all.add(keyframe.durationMillis() / MILLIS_PER_COORDINATE);
            joints.get(i).forEach(joint -> all.add(keyframe.posture().degrees(joint) / DEGREES_PER_COORDINATE));
        }
        return all.stream().mapToDouble(Double::doubleValue).toArray();
    }

    /**
     * Creates the motion that belongs to coordinates.
     *
     * @param coordinates any coordinates
     * @return a motion whose angles are within the joints' ranges
     */
    public Motion motion(double[] coordinates) {
        List<Keyframe> keyframes = new ArrayList<>(motion.keyframes());
        int at = 0;
        for (int i = 0; i < joints.size(); i++) {
            int millis = millis(coordinates[at++]);
            double[] degrees = keyframes.get(i).posture().toArray();
            boolean symmetric =
                    keyframes.get(i).posture().equals(keyframes.get(i).posture().mirrored());
            for (Joint joint : joints.get(i)) {
                double angle = inside(joint, coordinates[at++] * DEGREES_PER_COORDINATE);
                degrees[joint.ordinal()] = angle;
                if (symmetric) {
                    degrees[Mirror.partner(joint).ordinal()] = Mirror.mirroredDegrees(joint, angle);
                }
            }
            keyframes.set(i, new Keyframe(millis, Posture.of(degrees)));
        }
        return new Motion(motion.name(), keyframes);
    }

    /**
     * Measures by how much coordinates exceed the joints' ranges.
     *
     * @param coordinates any coordinates
     * @return sum of the angles beyond the joints' ranges, in degrees
     */
    public double degreesBeyondRange(double[] coordinates) {
        double sum = 0;
        int at = 0;
        for (List<Joint> keyframe : joints) {
            at++;
            for (Joint joint : keyframe) {
                double angle = coordinates[at++] * DEGREES_PER_COORDINATE;
                sum += Math.abs(angle - joint.clampDegrees(angle));
            }
        }
        return sum;
    }

    private static int millis(double coordinate) {
        double millis = Math.max(SHORTEST_MILLIS, Math.min(LONGEST_MILLIS, coordinate * MILLIS_PER_COORDINATE));
        return (int) Math.round(millis / 20) * 20;
    }

    private static double inside(Joint joint, double degrees) {
        double low = joint.minDegrees() + MARGIN_DEGREES;
        double high = joint.maxDegrees() - MARGIN_DEGREES;
        return Math.round(Math.max(low, Math.min(high, degrees)) * 10) / 10.0;
    }
}
