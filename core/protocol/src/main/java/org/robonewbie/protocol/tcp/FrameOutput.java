package org.robonewbie.protocol.tcp;

import java.io.IOException;
import java.io.OutputStream;
import org.robonewbie.protocol.frame.MessageBuffer;

/**
 * Writes length-prefixed messages to a stream. The prefix and the message are sent in one write, because some SimSpark
 * clients fail if they arrive separately.
 */
public final class FrameOutput {

    private final OutputStream stream;
    private final MessageBuffer frame = new MessageBuffer();

    /**
     * Creates an output.
     *
     * @param stream the stream to write to; should be unbuffered
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
}
