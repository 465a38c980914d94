package org.robonewbie.programs.process;

/**
 * Reason why a robot of a {@link RobotProcess} has left.
 *
 * @param cause the cause
 * @param text the exception, the line of an infinite loop, the reason for slowness or the exit code, depending on the
 *     cause; may be empty
 * @param advice what to do about it, if this depends on the program; otherwise empty
 */
public record Departure(Cause cause, String text, String advice) {

    /** Cause of a departure. */
    public enum Cause {
        /** None: the robot stayed until the trial was over. */
        NONE,
        /** A step failed and the program continued. */
        FAILED_STEP,
        /** The program threw an exception. */
        THROWN,
        /** A step of the program did not return. */
        ENDLESS,
        /** The program slept or waited for too long in its steps. */
        IDLE,
        /** The process exited. */
        EXIT,
        /** The process exhausted its memory. */
        MEMORY,
        /** The program ran too many processes or used too much processor time. */
        EXCESS
    }

    private static final String SEPARATOR = "\t";

    static Departure read(String line) {
        String[] words = line.split(SEPARATOR, 3);
        return new Departure(Cause.valueOf(words[0]), words[1], words[2]);
    }

    String line() {
        return cause + SEPARATOR + text.replace('\t', ' ') + SEPARATOR + advice;
    }
}
