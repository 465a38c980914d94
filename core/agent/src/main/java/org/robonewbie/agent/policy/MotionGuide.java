package org.robonewbie.agent.policy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.motion.Interpolation;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.KeyframeInterval;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;

/**
 * A keyframe motion that a policy corrects: the reference posture in each cycle, and the progress of the motion as
 * inputs for a network.
 *
 * <pre>{@code
 * MotionGuide guide = new MotionGuide(motion, postureNow);
 * Posture wanted = guide.posture(1);
 * }</pre>
 */
public final class MotionGuide {

    /**
     * Name of the policy's parameter list that contains the motion: for each keyframe, its duration in milliseconds and
     * the angles of all joints in degrees.
     */
    public static final String MOTION = "motion";

    private static final int WAVES = 3;
    private static final int NUMBERS_PER_KEYFRAME = 1 + Joint.COUNT;
    private static final double MILLIS_PER_CYCLE = 1000 * Cycle.SECONDS;

    /**
     * Inputs that encode the progress of the motion: sin(kπp) and cos(kπp), where p is the completed fraction of the
     * motion and k = 1, 2, ….
     */
    public static final List<Quantity> PROGRESS = progress();

    private final Motion motion;
    private final Posture start;

    /**
     * Creates a guide.
     *
     * @param motion the motion
     * @param start posture at the beginning
     */
    public MotionGuide(Motion motion, Posture start) {
        this.motion = motion;
        this.start = start;
    }

    /**
     * Encodes a motion as a parameter list of a policy.
     *
     * @param motion the motion
     * @return for each keyframe, its duration in milliseconds and the angles of all joints in degrees
     */
    public static List<Double> numbers(Motion motion) {
        List<Double> numbers = new ArrayList<>();
        for (Keyframe keyframe : motion.keyframes()) {
            numbers.add((double) keyframe.durationMillis());
            Arrays.stream(keyframe.posture().toArray()).forEach(numbers::add);
        }
        return numbers;
    }

    /**
     * Decodes the motion of a policy.
     *
     * @param name name of the motion
     * @param numbers encoded motion, as returned by {@link #numbers}
     * @return the motion
     * @throws IllegalArgumentException if a keyframe is incomplete
     */
    public static Motion motion(String name, double... numbers) {
        if (numbers.length % NUMBERS_PER_KEYFRAME != 0) {
            throw new IllegalArgumentException("A motion of " + numbers.length
                    + " numbers contains an incomplete keyframe; each has " + NUMBERS_PER_KEYFRAME + " numbers.");
        }
        List<Keyframe> keyframes = new ArrayList<>();
        for (int i = 0; i < numbers.length; i += NUMBERS_PER_KEYFRAME) {
            double[] degrees = Arrays.copyOfRange(numbers, i + 1, i + NUMBERS_PER_KEYFRAME);
            keyframes.add(new Keyframe((int) numbers[i], Posture.of(degrees)));
        }
        return new Motion(name, keyframes);
    }

    private static List<Quantity> progress() {
        List<Quantity> all = new ArrayList<>();
        for (int wave = 1; wave <= WAVES; wave++) {
            all.add(new Quantity("motion.sine-" + wave, "1"));
            all.add(new Quantity("motion.cosine-" + wave, "1"));
        }
        return List.copyOf(all);
    }

    /**
     * Returns the reference posture.
     *
     * @param cycles cycles of 20 ms since the beginning
     * @return the posture; after the end, the last one
     */
    public Posture posture(int cycles) {
        double millis = cycles * MILLIS_PER_CYCLE;
        for (int i = 0; i < motion.keyframes().size(); i++) {
            KeyframeInterval section = new KeyframeInterval(start, motion, i);
            if (millis < section.durationMillis()) {
                return between(section, millis / section.durationMillis());
            }
            millis -= section.durationMillis();
        }
        return motion.keyframes().isEmpty()
                ? start
                : motion.keyframes().get(motion.keyframes().size() - 1).posture();
    }

    private static Posture between(KeyframeInterval section, double fraction) {
        return Posture.of(Arrays.stream(Joint.values())
                .mapToDouble(joint -> Interpolation.LINEAR.degrees(section, joint, fraction))
                .toArray());
    }

    /**
     * Returns the encoded progress of the motion.
     *
     * @param cycles cycles of 20 ms since the beginning
     * @return the values of {@link #PROGRESS}, as a new array
     */
    public double[] progress(int cycles) {
        double angle = Math.PI * Math.min(1, cycles * MILLIS_PER_CYCLE / Math.max(1, motion.durationMillis()));
        double[] all = new double[2 * WAVES];
        for (int wave = 1; wave <= WAVES; wave++) {
            all[2 * wave - 2] = PortableMath.sin(wave * angle);
            all[2 * wave - 1] = PortableMath.cos(wave * angle);
        }
        return all;
    }

    /**
     * Returns whether the motion is over.
     *
     * @param cycles cycles of 20 ms since the beginning
     * @return whether it has reached its last posture
     */
    public boolean isOver(int cycles) {
        return cycles * MILLIS_PER_CYCLE >= motion.durationMillis();
    }
}
