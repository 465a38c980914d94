package org.robonewbie.agent;

/**
 * The program was called in a way that it cannot start with, for example with an unknown option or without a server. Its
 * message is one sentence for the user: what happened and what to do.
 */
public final class StartUpException extends RuntimeException {

    private static final long serialVersionUID = 1;

    /**
     * Creates the exception.
     *
     * @param message what happened, the value, and what to do
     */
    public StartUpException(String message) {
        super(message);
    }
}
