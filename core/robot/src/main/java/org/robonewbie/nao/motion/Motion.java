package org.robonewbie.nao.motion;

import java.util.List;
import org.robonewbie.nao.math.PortableMath;

/**
 * A movement of the whole body, given by keyframes as in animation. Immutable.
 *
 * <pre>{@code
 * Motion wave = MotionFiles.load(Path.of("wave.txt")).motion();
 * Motion waveWithTheOtherHand = wave.mirrored();
 * }</pre>
 *
 * @param name name of the motion, such as {@code walk-forward}
 * @param keyframes the keyframes in playing order
 */
public record Motion(String name, List<Keyframe> keyframes) {

    /** Stores an unmodifiable copy of the list. */
    public Motion {
        keyframes = List.copyOf(keyframes);
    }

    /** {@return the joints that the motion moves; those of the NAO if there is no keyframe} */
    public JointSpace jointSpace() {
        return keyframes.isEmpty() ? JointSpace.NAO : keyframes.get(0).posture().jointSpace();
    }

    /** {@return the sum of the keyframes' durations in milliseconds} */
    public int durationMillis() {
        return keyframes.stream().mapToInt(Keyframe::durationMillis).sum();
    }

    /**
     * Returns a copy of this motion with the given name.
     *
     * @param newName the new name
     * @return the renamed motion
     */
    public Motion named(String newName) {
        return new Motion(newName, keyframes);
    }

    /**
     * Returns the mirrored motion: a turn to the left becomes a turn to the right.
     *
     * @return the motion with left and right exchanged
     */
    public Motion mirrored() {
        return new Motion(
                name,
                keyframes.stream()
                        .map(keyframe -> new Keyframe(
                                keyframe.durationMillis(), keyframe.posture().mirrored()))
                        .toList());
    }

    /**
     * Returns a slower or faster copy of this motion.
     *
     * @param factor the factor for each duration; above 1 is slower
     * @return the same postures with scaled durations, rounded to whole cycles of 20 ms, at least one
     * @throws IllegalArgumentException if the factor is not a positive finite number
     */
    public Motion stretched(double factor) {
        if (!(factor > 0) || Double.isInfinite(factor)) {
            throw new IllegalArgumentException(
                    "Cannot stretch a motion by the factor " + factor + ". Use a positive number such as 2.0.");
        }
        return new Motion(
                name,
                keyframes.stream()
                        .map(keyframe ->
                                new Keyframe(wholeCycles(factor * keyframe.durationMillis()), keyframe.posture()))
                        .toList());
    }

    private static int wholeCycles(double millis) {
        return (int) Math.max(1, PortableMath.round(millis / 20)) * 20;
    }
}
