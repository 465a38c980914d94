package org.robonewbie.web;

import java.io.ByteArrayOutputStream;
import java.util.Arrays;
import org.robonewbie.simulator.recording.RecordingTarget;

/** The recording of the world that the page shows, from its beginning; after about an hour of one robot it does not grow any more. */
final class MemoryRecording implements RecordingTarget {

    private static final int MOST_BYTES = 40_000_000;

    private final ByteArrayOutputStream content = new ByteArrayOutputStream();
    private boolean full;

    @Override
    public void write(byte[] bytes, int length) {
        full |= content.size() + length > MOST_BYTES;
        if (!full) {
            content.write(bytes, 0, length);
        }
    }

    @Override
    public void flush() {
        // it is there already
    }

    @Override
    public void close() {
        // a page may still look at it
    }

    /**
     * Reads on.
     *
     * @param from how many bytes are known already
     * @return the bytes behind them
     */
    byte[] read(int from) {
        byte[] all = content.toByteArray();
        return Arrays.copyOfRange(all, Math.min(from, all.length), all.length);
    }
}
