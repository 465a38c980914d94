package org.robonewbie.web;

import java.io.ByteArrayOutputStream;
import org.robonewbie.simulator.recording.RecordingTarget;

/** Recording of the displayed world, sent to the page in pieces. */
final class PageRecording implements RecordingTarget {

    private final ByteArrayOutputStream waiting = new ByteArrayOutputStream();
    private boolean started;

    /** Receiver of the pieces. */
    interface Taker {

        /**
         * Receives the next piece.
         *
         * @param bytes bytes of the recording
         * @param first whether these are the first bytes of the recording
         */
        void take(byte[] bytes, boolean first);
    }

    @Override
    public void write(byte[] bytes, int length) {
        waiting.write(bytes, 0, length);
    }

    @Override
    public void flush() {
        // Data is sent by sendTo.
    }

    @Override
    public void close() {
        // Data is sent by sendTo.
    }

    /**
     * Sends the bytes recorded since the last call, if any.
     *
     * @param page the receiver
     */
    void sendTo(Taker page) {
        if (waiting.size() > 0) {
            page.take(waiting.toByteArray(), !started);
            waiting.reset();
            started = true;
        }
    }
}
