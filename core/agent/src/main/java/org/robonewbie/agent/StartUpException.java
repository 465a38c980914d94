package org.robonewbie.agent;

/**
 * Thrown when a program cannot start, for example because of an unknown option or a missing server. The message is one sentence
 * for the user: what happened and what to do.
 */
public final class StartUpException extends RuntimeException {

    private static final long serialVersionUID = 1;

    /**
     * Creates the exception.
     *
     * @param message what happened, the value that caused it, and what to do
     */
    public StartUpException(String message) {
        super(message);
    }
}
