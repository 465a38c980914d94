package org.robonewbie.simulator.server;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.ReadableByteChannel;
import java.util.Arrays;
import org.robonewbie.protocol.frame.MessageBuffer;

/**
 * Cuts a stream of bytes into messages, each of which is preceded by its length in four bytes, most significant first.
 *
 * <p>Memory grows with the bytes that have arrived, never with the length that is announced.
 */
final class FrameDecoder {

    /** Longest message that is accepted, in bytes: a thousand times what a robot needs. */
    static final int MAXIMUM_LENGTH = 1 << 20;

    private static final int PREFIX = 4;
    private static final int INITIAL_CAPACITY = 4096;

    private byte[] bytes = new byte[INITIAL_CAPACITY];
    private int start;
    private int end;

    /**
     * Takes what has arrived.
     *
     * @param channel where to read from, not waiting
     * @param limit how many bytes to read at most
     * @return how many bytes were read, or -1 at the end of the stream
     */
    int fill(ReadableByteChannel channel, int limit) throws IOException {
        int total = 0;
        while (total < limit) {
            makeRoom();
            int count = channel.read(ByteBuffer.wrap(bytes, end, Math.min(bytes.length - end, limit - total)));
            if (count < 0) {
                return total > 0 ? total : -1;
            }
            if (count == 0) {
                return total;
            }
            end += count;
            total += count;
        }
        return total;
    }

    /**
     * Takes the next message if all of it has arrived.
     *
     * @param message takes the message
     * @return false if it has not
     * @throws IOException if the announced length is too great
     */
    boolean next(MessageBuffer message) throws IOException {
        if (end - start < PREFIX) {
            return false;
        }
        long length = Integer.toUnsignedLong(ByteBuffer.wrap(bytes, start, PREFIX).getInt());
        if (length > MAXIMUM_LENGTH) {
            throw new IOException("announced a message of " + length + " bytes, but at most " + MAXIMUM_LENGTH
                    + " are taken. Does it send the length as four bytes, most significant first?");
        }
        if (end - start - PREFIX < length) {
            return false;
        }
        message.clear();
        message.resize((int) length);
        System.arraycopy(bytes, start + PREFIX, message.bytes(), 0, (int) length);
        start += PREFIX + (int) length;
        return true;
    }

    private void makeRoom() {
        if (start == end) {
            start = 0;
            end = 0;
            if (bytes.length > INITIAL_CAPACITY) {
                bytes = new byte[INITIAL_CAPACITY];
            }
        } else if (end == bytes.length && start > 0) {
            System.arraycopy(bytes, start, bytes, 0, end - start);
            end -= start;
            start = 0;
        } else if (end == bytes.length) {
            bytes = Arrays.copyOf(bytes, 2 * bytes.length);
        }
    }
}
