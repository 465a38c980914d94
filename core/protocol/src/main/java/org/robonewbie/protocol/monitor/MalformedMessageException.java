package org.robonewbie.protocol.monitor;

/** A monitor message is malformed. It carries no text because the reader drops such messages silently. */
final class MalformedMessageException extends Exception {

    MalformedMessageException() {
        super("Monitor message is malformed", null, false, false);
    }
}
