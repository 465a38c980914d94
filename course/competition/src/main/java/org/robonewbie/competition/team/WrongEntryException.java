package org.robonewbie.competition.team;

/** A contest cannot be held as it was asked for; the message says what to write instead. */
public final class WrongEntryException extends RuntimeException {

    private static final long serialVersionUID = 1;

    /**
     * Creates the exception.
     *
     * @param message what is wrong and what to do
     */
    public WrongEntryException(String message) {
        super(message);
    }
}
