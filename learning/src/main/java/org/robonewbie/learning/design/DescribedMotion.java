package org.robonewbie.learning.design;

import java.util.regex.Pattern;
import org.robonewbie.nao.motion.Motion;

/**
 * A motion and what its file says about it.
 *
 * @param motion the motion
 * @param does what the robot does, in a few words
 * @param start the posture in which it may begin
 * @param end the posture in which it ends
 */
public record DescribedMotion(Motion motion, String does, String start, String end) {

    private static final Pattern SIDE = Pattern.compile("\\b(left|right)\\b");

    /**
     * Makes the same motion for the other side.
     *
     * @return left and right exchanged in movement, name and words
     */
    public DescribedMotion mirrored() {
        return new DescribedMotion(
                motion.mirrored().named(otherSide(motion.name())), otherSide(does), otherSide(start), otherSide(end));
    }

    private static String otherSide(String text) {
        return SIDE.matcher(text).replaceAll(side -> side.group().equals("left") ? "right" : "left");
    }
}
