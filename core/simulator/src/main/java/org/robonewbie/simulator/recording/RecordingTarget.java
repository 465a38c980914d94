package org.robonewbie.simulator.recording;

/** Where the bytes of a recording go, such as a file. What goes wrong there must not disturb the run. */
public interface RecordingTarget {

    /** Keeps nothing: the recording is only checked. */
    RecordingTarget NONE = new RecordingTarget() {

        @Override
        public void write(byte[] bytes, int length) {}

        @Override
        public void flush() {}

        @Override
        public void close() {}
    };

    /**
     * Takes the next bytes.
     *
     * @param bytes begins with them; to be copied
     * @param length how many there are
     */
    void write(byte[] bytes, int length);

    /** Brings all that was written to where it can be read. */
    void flush();

    /** Ends the recording. */
    void close();
}
