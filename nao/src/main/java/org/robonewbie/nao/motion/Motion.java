package org.robonewbie.nao.motion;

import java.util.ArrayList;
import java.util.List;

/**
 * A movement of the whole body, given by keyframes as in an animated film. Unmodifiable.
 *
 * <pre>{@code
 * Motion wave = MotionFile.load(Path.of("wave.txt")).motion();
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

    /**
     * Tells how long the motion takes.
     *
     * @return the sum of the durations in milliseconds
     */
    public int durationMillis() {
        return keyframes.stream().mapToInt(Keyframe::durationMillis).sum();
    }

    /**
     * Gives the motion another name.
     *
     * @param newName the new name
     * @return the same movement
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
     * @param factor what each duration is multiplied by; above 1 is slower; results are rounded to whole cycles of 20 ms, at least
     *     one
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
     * Plays the motion backwards: the postures in the opposite order, each way with the duration that it had. The first keyframe
     * keeps its place in time, since from where the robot comes is not part of a motion.
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
        return (int) Math.max(1, Math.round(millis / 20)) * 20;
    }
}
