package org.robonewbie.protocol.tcp;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.WritableByteChannel;
import org.robonewbie.protocol.frame.MessageBuffer;

/**
 * Sends messages to a non-blocking channel, for servers with slow clients. As in rcssserver3d, at most one message is
 * pending for each client. New messages are dropped until the pending one has been sent completely, so a slow client
 * uses no extra memory and never receives a partial message.
 */
public final class FrameEncoder {

    private final MessageBuffer frame = new MessageBuffer();
    private ByteBuffer pending = ByteBuffer.allocate(0);

    /** Creates an encoder for one client. */
    public FrameEncoder() {}

    /**
     * Sends a message. If another message is still pending, continues to send that one and drops the new one.
     *
     * @param channel the client's channel
     * @param message the message
     * @return false if the message was dropped
     * @throws IOException if the connection is broken
     */
    public boolean send(WritableByteChannel channel, MessageBuffer message) throws IOException {
        if (isPending()) {
            flush(channel);
            return false;
        }
        frame.clear();
        LengthPrefix.append(message, frame);
        pending = ByteBuffer.wrap(frame.bytes(), 0, frame.length());
        flush(channel);
        return true;
    }

    /**
     * Continues to send the pending message, as far as the channel accepts data.
     *
     * @param channel the client's channel
     * @throws IOException if the connection is broken
     */
    public void flush(WritableByteChannel channel) throws IOException {
        if (isPending()) {
            channel.write(pending);
        }
    }

    /** {@return whether a message is pending} */
    public boolean isPending() {
        return pending.hasRemaining();
    }
}
