package org.robonewbie.learning.design;

import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;
import org.robonewbie.nao.motion.Motion;

/**
 * A motion and what its file says about it.
 *
 * @param motion the motion
 * @param does what the robot does, in a few words
 * @param start the posture in which it may begin
 * @param end the posture in which it ends
 * @param more what else its file says
 */
public record DescribedMotion(Motion motion, String does, String start, String end, Map<String, String> more) {

    private static final Pattern SIDE = Pattern.compile("\\b(left|right)\\b");

    /**
     * Describes a motion of which there is nothing else to say.
     *
     * @param motion the motion
     * @param does what the robot does, in a few words
     * @param start the posture in which it may begin
     * @param end the posture in which it ends
     */
    public DescribedMotion(Motion motion, String does, String start, String end) {
        this(motion, does, start, end, Map.of());
    }

    /** Adds or replaces a line of the file. */
    DescribedMotion with(String key, String value) {
        Map<String, String> all = new TreeMap<>(more);
        all.put(key, value);
        return new DescribedMotion(motion, does, start, end, all);
    }

    /** {@return the mirror image of the motion: left and right exchanged in movement, name and words} */
    public DescribedMotion mirrored() {
        return new DescribedMotion(
                motion.mirrored().named(otherSide(motion.name())),
                otherSide(does),
                otherSide(start),
                otherSide(end),
                more);
    }

    private static String otherSide(String text) {
        return SIDE.matcher(text).replaceAll(side -> side.group().equals("left") ? "right" : "left");
    }
}
