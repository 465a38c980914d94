package org.robonewbie.simulator.recording;

import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;

/** Where the bytes of a recording go: into a checksum and to their target. */
final class RecordingStream implements AutoCloseable {

    private final MessageDigest digest;
    private final RecordingTarget target;

    RecordingStream(RecordingTarget target) {
        this.target = target;
        try {
            digest = MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("This Java has no SHA-256, which every Java must have", e);
        }
    }

    void write(ByteSink sink) {
        digest.update(sink.bytes(), 0, sink.length());
        target.write(sink.bytes(), sink.length());
    }

    void flush() {
        target.flush();
    }

    /** {@return the checksum of all bytes so far, SHA-256 in 64 hexadecimal digits} */
    String sha256() {
        try {
            return HexFormat.of().formatHex(((MessageDigest) digest.clone()).digest());
        } catch (CloneNotSupportedException e) {
            throw new IllegalStateException("The checksum cannot be read", e);
        }
    }

    @Override
    public void close() {
        target.close();
    }
}
