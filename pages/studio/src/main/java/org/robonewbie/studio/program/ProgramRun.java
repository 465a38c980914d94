package org.robonewbie.studio.program;

/**
 * How far the program is that a page has started.
 *
 * @param id number of the start, 0 if nothing was started yet
 * @param state where it is
 * @param program path of its file
 * @param output the end of what it has printed
 * @param exitCode how its process has ended
 */
public record ProgramRun(long id, State state, String program, String output, int exitCode) {

    /** The state before the first start. */
    public static final ProgramRun NONE = new ProgramRun(0, State.NONE, "", "", 0);

    /** The stages of a program. */
    public enum State {
        /** Nothing was started. */
        NONE,
        /** The program is being compiled, or has not come to the pitch yet. */
        STARTING,
        /** The program runs. */
        RUNNING,
        /** The program has ended by itself. */
        ENDED,
        /** It was stopped. */
        STOPPED,
        /** The compiler has refused it. */
        REFUSED
    }
}
