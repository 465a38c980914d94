package org.robonewbie.agent.motion;

import java.util.List;
import org.robonewbie.nao.motion.MotionFile;

/**
 * Knows in which state the last motion has left the robot, so that a motion never begins in the middle of a step. Motion files
 * say in comments in which states they can start and in which they end: {@code // start: stance, walking} and
 * {@code // end: stance}. A state is a word of the author's choice; {@code the end of NAME} stands for the end of that very
 * motion.
 */
final class MotionStates {

    private static final String STANDING = "standing";
    private static final String STANCE = "stance";
    private static final String LYING = "lying";
    /** Motions that lead from one state to another, the most careful one first. */
    static final List<String> BRIDGES = List.of("stop-walking", "stand", "start-walking");

    private String state = STANDING;
    private String lastMotion = "";

    /** The robot's posture is unknown, but no motion is running. */
    void reset() {
        state = STANDING;
        lastMotion = "";
    }

    /** A motion has run to its end. */
    void ended(MotionFile file) {
        state = endOf(file);
        lastMotion = nameOf(file);
    }

    /** Whether the robot will be in the stance. */
    boolean isStance() {
        return state.equals(STANCE);
    }

    /** Whether a motion can start now. Without a comment about it, it starts whenever the robot stands. */
    boolean canStart(MotionFile file) {
        return canStart(file, state, lastMotion);
    }

    /** Whether a motion can start as soon as another one has ended. */
    static boolean canStartAfter(MotionFile before, MotionFile file) {
        return canStart(file, endOf(before), nameOf(before));
    }

    private static boolean canStart(MotionFile file, String state, String lastMotion) {
        String starts = file.property("start").orElse(STANDING + ", " + STANCE);
        for (String start : starts.split(",| or ", -1)) {
            String wanted = start.trim();
            if (wanted.equals(state)
                    || wanted.equals("the end of " + lastMotion)
                    || (wanted.equals(STANDING) && state.equals(STANCE))) {
                return true;
            }
        }
        return false;
    }

    /** Whether a motion makes sense only on the feet, by its own comments. */
    static boolean needsFeet(MotionFile file) {
        return file.property("start").filter(start -> !start.startsWith(LYING)).isPresent();
    }

    private static String endOf(MotionFile file) {
        return file.property("end").map(end -> end.split(",", 2)[0].trim()).orElse(STANDING);
    }

    private static String nameOf(MotionFile file) {
        return file.name().replaceFirst("\\.txt$", "");
    }
}
