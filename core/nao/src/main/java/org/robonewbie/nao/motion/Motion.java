package org.robonewbie.nao.motion;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.math.PortableMath;

/**
 * A movement of the whole body, given by keyframes as in an animated film. Unmodifiable.
 *
 * <pre>{@code
 * Motion wave = MotionFiles.load(Path.of("wave.txt")).motion();
 * Motion waveWithTheOtherHand = wave.mirrored();
 * }</pre>
 *
 * @param name what the motion is called, such as {@code walk-forward}
 * @param keyframes the postures in their order
 */
public record Motion(String name, List<Keyframe> keyframes) {

    /** Makes the list unmodifiable. */
    public Motion {
        keyframes = List.copyOf(keyframes);
    }

    /** {@return the duration of the motion, the sum of its keyframes' durations, in milliseconds} */
    public int durationMillis() {
        return keyframes.stream().mapToInt(Keyframe::durationMillis).sum();
    }

    /**
     * Renames the motion.
     *
     * @param newName the new name
     * @return the same movement under the new name
     */
    public Motion named(String newName) {
        return new Motion(newName, keyframes);
    }

    /**
     * Exchanges left and right: a turn to the left becomes a turn to the right.
     *
     * @return the movement of this robot's reflection in a mirror
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
     * Makes the motion slower or faster.
     *
     * @param factor the factor for each duration; above 1 is slower; results are rounded to whole cycles of 20 ms, at least one
     * @return the same postures with other durations
     * @throws IllegalArgumentException if the factor is not a positive finite number
     */
    public Motion stretched(double factor) {
        if (!(factor > 0) || Double.isInfinite(factor)) {
            throw new IllegalArgumentException(
                    "A motion cannot be stretched by the factor " + factor + ". Use a positive number such as 2.0.");
        }
        return new Motion(
                name,
                keyframes.stream()
                        .map(keyframe ->
                                new Keyframe(wholeCycles(factor * keyframe.durationMillis()), keyframe.posture()))
                        .toList());
    }

    /**
     * Reverses the motion: the postures in the opposite order, each reached in the time that it had. The first keyframe keeps
     * its duration, since the posture before it is not part of the motion.
     *
     * @return the reversed motion, which ends in this motion's first posture
     */
    public Motion reversed() {
        int count = keyframes.size();
        List<Keyframe> reversed = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            int duration = keyframes.get((count - i) % count).durationMillis();
            reversed.add(new Keyframe(duration, keyframes.get(count - 1 - i).posture()));
        }
        return new Motion(name, reversed);
    }

    private static int wholeCycles(double millis) {
        return (int) Math.max(1, PortableMath.round(millis / 20)) * 20;
    }
}
