package org.robonewbie.protocol.tcp;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import org.robonewbie.protocol.frame.MessageBuffer;

/**
 * Writes length-prefixed messages to a stream, prefix and message in one write, since some SimSpark clients fail if they arrive
 * separately.
 */
public final class FrameOutput implements Closeable {

    private final OutputStream stream;
    private final MessageBuffer frame = new MessageBuffer();

    /**
     * Creates an output.
     *
     * @param stream where the bytes go; should not be buffered
     */
    public FrameOutput(OutputStream stream) {
        this.stream = stream;
    }

    /**
     * Writes one message.
     *
     * @param message the message
     * @throws IOException if the stream cannot be written
     */
    public void write(MessageBuffer message) throws IOException {
        frame.clear();
        LengthPrefix.append(message, frame);
        stream.write(frame.bytes(), 0, frame.length());
        stream.flush();
    }

    @Override
    public void close() throws IOException {
        stream.close();
    }
}
