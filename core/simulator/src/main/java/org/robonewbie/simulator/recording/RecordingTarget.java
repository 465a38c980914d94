package org.robonewbie.simulator.recording;

/**
 * A destination for the bytes of a recording, such as a file. Implementations must not throw exceptions, so that a
 * failure does not affect the run.
 */
public interface RecordingTarget {

    /** A target that discards all bytes; the checksum of the recording is still computed. */
    RecordingTarget NONE = new RecordingTarget() {

        @Override
        public void write(byte[] bytes, int length) {}

        @Override
        public void flush() {}

        @Override
        public void close() {}
    };

    /**
     * Writes the next bytes of the recording.
     *
     * @param bytes array that starts with the bytes to write; reused by the caller
     * @param length number of bytes to write
     */
    void write(byte[] bytes, int length);

    /** Flushes buffered bytes. */
    void flush();

    /** Ends the recording. */
    void close();
}
