package org.robonewbie.programs.process;

/** Thrown when a program in another process has not joined, has left or does not respond. The message is meant for students. */
public final class AbsentProgramException extends RuntimeException {

    private static final long serialVersionUID = 1;

    /**
     * Creates the exception.
     *
     * @param message what happened, as a sentence
     */
    public AbsentProgramException(String message) {
        super(message);
    }

    /**
     * Creates the exception.
     *
     * @param message what happened, as a sentence
     * @param cause the I/O failure
     */
    public AbsentProgramException(String message, Throwable cause) {
        super(message, cause);
    }
}
