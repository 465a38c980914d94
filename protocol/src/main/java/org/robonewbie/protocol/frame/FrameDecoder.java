package org.robonewbie.protocol.frame;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.ReadableByteChannel;
import java.util.Arrays;

/**
 * Collects the bytes of a channel that never blocks until whole messages have arrived: for servers that look at each client
 * once per cycle. It never holds more than one message of the greatest length and one chunk.
 *
 * <pre>{@code
 * open = decoder.fillFrom(channel);
 * while (decoder.next(message)) { ... }
 * }</pre>
 */
public final class FrameDecoder {

    private static final int CHUNK_BYTES = 1 << 14;

    private final int maxBytes;
    private byte[] bytes = new byte[CHUNK_BYTES];
    private int start;
    private int end;

    /**
     * Creates a decoder for one client.
     *
     * @param maxBytes the longest message that is accepted, in bytes
     */
    public FrameDecoder(int maxBytes) {
        this.maxBytes = maxBytes;
    }

    /**
     * Takes what the channel has ready, up to one chunk of 16 KiB, so that no client takes more of a server's time than its share;
     * to be called until it returns 0 or -1 if everything is wanted, with all messages taken out by {@link #next} in between.
     *
     * @param channel the client's channel
     * @return how many bytes were read; 0 if none are there, -1 if the client has closed the connection
     * @throws IOException if the connection is broken
     */
    public int fillFrom(ReadableByteChannel channel) throws IOException {
        makeRoom();
        int count = channel.read(ByteBuffer.wrap(bytes, end, Math.min(CHUNK_BYTES, bytes.length - end)));
        end += Math.max(0, count);
        return count;
    }

    /**
     * Takes out the next complete message.
     *
     * @param message takes the message; untouched if there is none
     * @return whether there was a complete message
     * @throws FrameTooLongException if the client announces a message that is longer than accepted
     */
    public boolean next(MessageBuffer message) throws FrameTooLongException {
        if (end - start < LengthPrefix.BYTES) {
            return false;
        }
        int length = LengthPrefix.read(bytes, start, maxBytes);
        if (end - start - LengthPrefix.BYTES < length) {
            return false;
        }
        message.clear();
        message.resize(length);
        System.arraycopy(bytes, start + LengthPrefix.BYTES, message.bytes(), 0, length);
        start += LengthPrefix.BYTES + length;
        return true;
    }

    private void makeRoom() {
        if (start > 0) {
            System.arraycopy(bytes, start, bytes, 0, end - start);
            end -= start;
            start = 0;
        }
        if (bytes.length - end < CHUNK_BYTES / 2) {
            bytes = Arrays.copyOf(bytes, bytes.length * 2);
        }
    }
}
