package org.robonewbie.simulator.recording;

import java.io.IOException;

/** Thrown for a file that is not a recording or is damaged. The message can be shown to the user. */
public final class DamagedRecordingException extends IOException {

    private static final long serialVersionUID = 1;

    /**
     * Creates the exception.
     *
     * @param message the problem as a sentence
     */
    public DamagedRecordingException(String message) {
        super(message);
    }

    /**
     * Creates the exception.
     *
     * @param message the problem as a sentence
     * @param cause the cause
     */
    public DamagedRecordingException(String message, Throwable cause) {
        super(message, cause);
    }
}
