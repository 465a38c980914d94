package org.robonewbie.programs.process;

/**
 * Why a robot of a {@link RobotProcess} has gone.
 *
 * @param cause what has happened
 * @param text what was thrown, the place of an endless loop, what makes the program slow, or the exit code; empty if there is no such
 * @param advice what to do, if that depends on the program; else empty
 */
public record Departure(Cause cause, String text, String advice) {

    /** What has happened. */
    public enum Cause {
        /** The trial was over. */
        NONE,
        /** A step has failed, and the program went on. */
        FAILED_STEP,
        /** The program has thrown something. */
        THROWN,
        /** A step has not come to its end. */
        ENDLESS,
        /** Its steps sleep or wait for too long. */
        IDLE,
        /** The process has ended. */
        EXIT,
        /** The process has taken all memory. */
        MEMORY,
        /** The process has started too many processes, or has used too much processor time. */
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
