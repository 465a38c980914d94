package org.robonewbie.programs;

/** Thrown when a command is called with invalid arguments. The message says what to write instead. */
public final class CalledWronglyException extends RuntimeException {

    /**
     * Creates the exception.
     *
     * @param message what is wrong, and what to write instead
     */
    public CalledWronglyException(String message) {
        super(message);
    }
}
