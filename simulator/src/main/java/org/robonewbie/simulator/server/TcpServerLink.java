package org.robonewbie.simulator.server;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SocketChannel;
import org.robonewbie.protocol.frame.MessageBuffer;

/** The simulator's end of an agent's TCP connection. */
final class TcpServerLink implements ServerLink {

    /** How many bytes of one agent are read in one cycle; the rest waits in the network. */
    private static final int BYTES_PER_CYCLE = 1 << 16;

    private final SocketChannel channel;
    private final String address;
    private final FrameDecoder decoder = new FrameDecoder();
    private ByteBuffer outgoing = ByteBuffer.allocate(0);
    private String closingReason = "";
    private boolean open = true;
    private boolean ended;

    TcpServerLink(SocketChannel channel, String address) {
        this.channel = channel;
        this.address = address;
    }

    /** Reads what has arrived; called when the operating system has something. */
    void receive() {
        try {
            if (!ended && decoder.fill(channel, BYTES_PER_CYCLE) < 0) {
                ended = true;
            }
        } catch (IOException e) {
            end("has lost its connection (" + e.getMessage() + ").");
        }
    }

    @Override
    public boolean poll(MessageBuffer message) {
        if (!open) {
            return false;
        }
        try {
            if (decoder.next(message)) {
                return true;
            }
        } catch (IOException e) {
            end(e.getMessage() + " The connection is closed.");
            return false;
        }
        if (ended) {
            end("has left.");
        }
        return false;
    }

    @Override
    public boolean offer(MessageBuffer message) {
        boolean free = !outgoing.hasRemaining();
        if (free) {
            fillOutgoing(message);
        }
        try {
            channel.write(outgoing);
        } catch (IOException e) {
            end("has lost its connection (" + e.getMessage() + ").");
        }
        return free;
    }

    @Override
    public boolean isOpen() {
        return open;
    }

    @Override
    public String closingReason() {
        return closingReason;
    }

    @Override
    public void close() {
        end("was disconnected.");
    }

    @Override
    public boolean isLocal() {
        return false;
    }

    @Override
    public String address() {
        return address;
    }

    private void fillOutgoing(MessageBuffer message) {
        int length = 4 + message.length();
        if (outgoing.capacity() < length) {
            outgoing = ByteBuffer.allocateDirect(2 * length);
        }
        outgoing.clear();
        outgoing.putInt(message.length());
        outgoing.put(message.bytes(), 0, message.length());
        outgoing.flip();
    }

    private void end(String reason) {
        if (open) {
            open = false;
            closingReason = reason;
            try {
                channel.close();
            } catch (IOException e) {
                // The connection is given up anyway.
            }
        }
    }
}
