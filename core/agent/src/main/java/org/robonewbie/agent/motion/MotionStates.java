package org.robonewbie.agent.motion;

import java.util.List;
import org.robonewbie.nao.motion.MotionFile;

/**
 * Tracks the state in which the last motion left the robot, so that no motion begins in the middle of a step. Motion
 * files declare in comments the states in which they can start and the state in which they end:
 * {@code // start: stance, walking} and {@code // end: stance}. The names of states are arbitrary;
 * {@code the end of NAME} denotes the end of that particular motion.
 */
final class MotionStates {

    private static final String STANDING = "standing";
    private static final String STANCE = "stance";
    private static final String LYING = "lying";
    /** Motions that lead from one state to another, in order of preference. */
    static final List<String> TRANSITIONS = List.of("stop-walking", "stand", "start-walking");

    private String state = STANDING;
    private String lastMotion = "";

    /** Resets the state: the posture is unknown, and no motion is running. */
    void reset() {
        state = STANDING;
        lastMotion = "";
    }

    void ended(MotionFile file) {
        state = endOf(file);
        lastMotion = nameOf(file);
    }

    boolean isStance() {
        return state.equals(STANCE);
    }

    /** Returns whether a motion can start now. A motion without a declaration can start whenever the robot is standing. */
    boolean canStart(MotionFile file) {
        return canStart(file, state, lastMotion);
    }

    /** Returns whether a motion can start immediately after another one. */
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

    /** Returns whether a motion declares that it starts with the robot on its feet. */
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
