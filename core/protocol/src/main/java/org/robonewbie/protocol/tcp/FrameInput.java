package org.robonewbie.protocol.tcp;

import java.io.Closeable;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import org.robonewbie.protocol.frame.MessageBuffer;

/** Reads length-prefixed messages from a stream: four bytes, most significant first, followed by that many bytes of text. */
public final class FrameInput implements Closeable {

    private final InputStream stream;
    private final int maxBytes;
    private final byte[] prefix = new byte[LengthPrefix.BYTES];

    /**
     * Creates an input.
     *
     * @param stream where the bytes come from
     * @param maxBytes the longest message that is accepted, in bytes
     */
    public FrameInput(InputStream stream, int maxBytes) {
        this.stream = stream;
        this.maxBytes = maxBytes;
    }

    /**
     * Waits for the next message.
     *
     * @param message receives the message
     * @return false if the stream has ended and there are no more messages
     * @throws FrameTooLongException if the message is longer than accepted
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
        return new EOFException("The other side ended the connection in the middle of a message.");
    }

    @Override
    public void close() throws IOException {
        stream.close();
    }
}
