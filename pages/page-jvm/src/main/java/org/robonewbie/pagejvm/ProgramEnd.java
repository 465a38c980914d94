package org.robonewbie.pagejvm;

/** {@code System.exit} was called. */
public final class ProgramEnd extends Error {

    private static final long serialVersionUID = 1;

    private final int exitCode;

    /**
     * Ends the program.
     *
     * @param exitCode 0 if all is well
     */
    public ProgramEnd(int exitCode) {
        super("The program has ended itself with exit code " + exitCode + ".");
        this.exitCode = exitCode;
    }

    /** {@return 0 if all is well} */
    public int exitCode() {
        return exitCode;
    }
}
