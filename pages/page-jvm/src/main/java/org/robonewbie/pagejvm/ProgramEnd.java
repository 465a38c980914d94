package org.robonewbie.pagejvm;

/** Thrown when the program calls {@code System.exit}. */
public final class ProgramEnd extends Error {

    private static final long serialVersionUID = 1;

    private final int exitCode;

    /**
     * Creates the error.
     *
     * @param exitCode exit code, 0 for success
     */
    public ProgramEnd(int exitCode) {
        super("The program has exited with code " + exitCode + ".");
        this.exitCode = exitCode;
    }

    /** {@return the exit code, 0 for success} */
    public int exitCode() {
        return exitCode;
    }
}
