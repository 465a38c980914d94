package org.robonewbie.protocol.tcp;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import org.robonewbie.protocol.frame.MessageBuffer;

/** Reads length-prefixed messages from a stream: a four-byte length in big-endian order, followed by the text. */
public final class FrameInput {

    private final InputStream stream;
    private final int maxBytes;
    private final byte[] prefix = new byte[LengthPrefix.BYTES];

    /**
     * Creates an input.
     *
     * @param stream the stream to read from
     * @param maxBytes maximum length of a message in bytes
     */
    public FrameInput(InputStream stream, int maxBytes) {
        this.stream = stream;
        this.maxBytes = maxBytes;
    }

    /**
     * Waits for the next message.
     *
     * @param message receives the message
     * @return false if the stream has ended
     * @throws FrameTooLongException if the message is too long
     * @throws EOFException if the stream ends within a message
     * @throws IOException if the stream cannot be read
     */
    public boolean read(MessageBuffer message) throws IOException {
        message.clear();
        int received = stream.readNBytes(prefix, 0, LengthPrefix.BYTES);
        if (received == 0) {
            return false;
        }
        if (received < LengthPrefix.BYTES) {
            throw cutOff();
        }
        message.resize(LengthPrefix.read(prefix, 0, maxBytes));
        if (stream.readNBytes(message.bytes(), 0, message.length()) < message.length()) {
            throw cutOff();
        }
        return true;
    }

    private static EOFException cutOff() {
        return new EOFException("The other side closed the connection in the middle of a message.");
    }
}
