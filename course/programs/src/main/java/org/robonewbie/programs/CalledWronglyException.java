package org.robonewbie.programs;

/** A command was called with something that cannot be; the message says what to write instead. */
public final class CalledWronglyException extends RuntimeException {

    /**
     * Creates the exception.
     *
     * @param message what was wrong and what to write instead
     */
    public CalledWronglyException(String message) {
        super(message);
    }
}
