package org.robonewbie.protocol.monitor;

/**
 * Thrown when a monitor message is malformed. The exception has no stack trace, because the reader drops such messages
 * silently.
 */
final class MalformedMessageException extends Exception {

    MalformedMessageException() {
        super("Monitor message is malformed", null, false, false);
    }
}
