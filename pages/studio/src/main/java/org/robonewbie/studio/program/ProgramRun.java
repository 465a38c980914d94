package org.robonewbie.studio.program;

/**
 * State of the program that a page has started.
 *
 * @param id number of the run, 0 before the first one
 * @param state current stage
 * @param program path of its file
 * @param output the tail of its output
 * @param exitCode exit code of its process
 */
public record ProgramRun(long id, State state, String program, String output, int exitCode) {

    /** The state before the first start. */
    public static final ProgramRun NONE = new ProgramRun(0, State.NONE, "", "", 0);

    /** The stages of a run. */
    public enum State {
        /** No program has been started. */
        NONE,
        /** The program is being compiled, or has not joined yet. */
        STARTING,
        /** The program is running. */
        RUNNING,
        /** The program has exited. */
        ENDED,
        /** The program was stopped by the user. */
        STOPPED,
        /** The program has compile errors. */
        REFUSED
    }
}
