package org.robonewbie.protocol.frame;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.WritableByteChannel;

/**
 * Sends messages through a channel that never blocks: for servers whose clients may be slow. As in rcssserver3d one message
 * at most is under way to each client; while it is not fully sent, new ones are thrown away, so that a slow client costs no
 * memory and never gets half a message.
 */
public final class FrameEncoder {

    private final MessageBuffer frame = new MessageBuffer();
    private ByteBuffer pending = ByteBuffer.allocate(0);

    /** Creates an encoder for one client. */
    public FrameEncoder() {}

    /**
     * Sends a message, or what is left of the message before.
     *
     * @param channel the client's channel
     * @param message the message
     * @return false if the message was thrown away because the one before was not fully sent yet
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
     * Sends more of the message that is under way, as much as the channel takes.
     *
     * @param channel the client's channel
     * @throws IOException if the connection is broken
     */
    public void flush(WritableByteChannel channel) throws IOException {
        if (isPending()) {
            channel.write(pending);
        }
    }

    /**
     * Tells whether a message is under way.
     *
     * @return whether some of its bytes are not sent yet
     */
    public boolean isPending() {
        return pending.hasRemaining();
    }
}
