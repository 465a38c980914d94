package org.robonewbie.simulator.recording;

import java.io.IOException;

/** A recording that makes no sense; the message is a sentence for people. */
public final class DamagedRecordingException extends IOException {

    private static final long serialVersionUID = 1;

    /**
     * Creates the exception.
     *
     * @param message what makes no sense
     */
    public DamagedRecordingException(String message) {
        super(message);
    }

    /**
     * Creates the exception.
     *
     * @param message what makes no sense
     * @param cause what was noticed
     */
    public DamagedRecordingException(String message, Throwable cause) {
        super(message, cause);
    }
}
