package org.robonewbie.protocol.tcp;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.WritableByteChannel;
import org.robonewbie.protocol.frame.MessageBuffer;

/**
 * Sends messages through a non-blocking channel: for servers whose clients may be slow. As in rcssserver3d, at most one message
 * is under way to each client; until it is fully sent, new ones are dropped, so that a slow client costs no memory and never
 * receives half a message.
 */
public final class FrameEncoder {

    private final MessageBuffer frame = new MessageBuffer();
    private ByteBuffer pending = ByteBuffer.allocate(0);

    /** Creates an encoder for one client. */
    public FrameEncoder() {}

    /**
     * Sends a message, or the rest of the previous one.
     *
     * @param channel the client's channel
     * @param message the message
     * @return false if the message was dropped because the previous one was not fully sent yet
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
     * Sends more of the message that is under way, as much as the channel accepts.
     *
     * @param channel the client's channel
     * @throws IOException if the connection is broken
     */
    public void flush(WritableByteChannel channel) throws IOException {
        if (isPending()) {
            channel.write(pending);
        }
    }

    /** {@return whether part of a message is still to be sent} */
    public boolean isPending() {
        return pending.hasRemaining();
    }
}
