package org.robonewbie.protocol.monitor;

/**
 * Thrown when a monitor message is malformed. It has no stack trace, since the reader catches it immediately and a misbehaving
 * server could trigger it in every message.
 */
final class MalformedMessageException extends Exception {

    private static final long serialVersionUID = 1;

    MalformedMessageException() {
        this("Monitor message is malformed");
    }

    /** Creates the exception with what is wrong, as the rest of a sentence that starts with the message's number. */
    MalformedMessageException(String problem) {
        super(problem, null, false, false);
    }
}
