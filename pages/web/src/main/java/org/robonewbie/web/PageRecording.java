package org.robonewbie.web;

import java.io.ByteArrayOutputStream;
import org.robonewbie.simulator.recording.RecordingTarget;

/** The recording of the world that the page shows, which the page gets piece by piece. */
final class PageRecording implements RecordingTarget {

    private final ByteArrayOutputStream waiting = new ByteArrayOutputStream();
    private boolean begun;

    /** Takes pieces of a recording. */
    interface Taker {

        /**
         * Takes the next piece.
         *
         * @param bytes of the recording
         * @param first whether the recording begins with them
         */
        void take(byte[] bytes, boolean first);
    }

    @Override
    public void write(byte[] bytes, int length) {
        waiting.write(bytes, 0, length);
    }

    @Override
    public void flush() {
        // each turn of the worker gives away what there is
    }

    @Override
    public void close() {
        // the same
    }

    /**
     * Gives away what has come since the last time, if there is anything.
     *
     * @param page gets it
     */
    void give(Taker page) {
        if (waiting.size() > 0) {
            page.take(waiting.toByteArray(), !begun);
            waiting.reset();
            begun = true;
        }
    }
}
