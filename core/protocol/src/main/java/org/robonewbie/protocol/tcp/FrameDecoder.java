package org.robonewbie.protocol.tcp;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.ReadableByteChannel;
import java.util.Arrays;
import org.robonewbie.protocol.frame.MessageBuffer;

/**
 * Assembles messages from the bytes that are read from a non-blocking channel, for servers that poll each client once per
 * cycle. It buffers at most one message of the maximum length and one chunk of 16 KiB.
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
     * @param maxBytes maximum length of a message in bytes
     */
    public FrameDecoder(int maxBytes) {
        this.maxBytes = maxBytes;
    }

    /**
     * Reads available bytes from the channel, at most one chunk of 16 KiB, so that no client monopolises the server. To read
     * everything, call this method until it returns 0 or -1, and remove all messages with {@link #next} after each call.
     *
     * @param channel the client's channel
     * @return number of bytes read; 0 if none are available, -1 if the client has closed the connection
     * @throws IOException if the connection is broken
     */
    public int fillFrom(ReadableByteChannel channel) throws IOException {
        makeRoom();
        int count = channel.read(ByteBuffer.wrap(bytes, end, Math.min(CHUNK_BYTES, bytes.length - end)));
        end += Math.max(0, count);
        return count;
    }

    /**
     * Removes the next complete message.
     *
     * @param message receives the message; unchanged if there is none
     * @return whether there was a complete message
     * @throws FrameTooLongException if the client announces a message that is too long
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
