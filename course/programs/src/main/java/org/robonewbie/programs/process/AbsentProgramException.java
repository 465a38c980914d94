package org.robonewbie.programs.process;

/** A program of another process has not come, has left, or gives no answer; the message is for students. */
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
     * @param cause how it was noticed
     */
    public AbsentProgramException(String message, Throwable cause) {
        super(message, cause);
    }
}
