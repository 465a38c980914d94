package org.robonewbie.app;

/** A command was called with something that cannot be; the message says what to write instead. */
final class CalledWronglyException extends RuntimeException {

    CalledWronglyException(String message) {
        super(message);
    }
}
