package org.robonewbie.simulator.server;

import java.io.IOException;
import java.nio.channels.SocketChannel;
import java.util.Optional;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.tcp.FrameDecoder;
import org.robonewbie.protocol.tcp.FrameEncoder;
import org.robonewbie.protocol.tcp.FrameTooLongException;
import org.robonewbie.simulator.cycle.ServerLink;

/** The simulator's end of an agent's connection over TCP or a Unix domain socket. */
final class TcpServerLink implements ServerLink {

    /** Maximum message length in bytes, about a hundred times what a robot needs. */
    static final int MAX_LENGTH = 1 << 18;

    private final SocketChannel channel;
    private final String address;
    private final Optional<String> team;
    private final FrameDecoder decoder = new FrameDecoder(MAX_LENGTH);
    private final FrameEncoder encoder = new FrameEncoder();
    private String closingReason = "";
    private boolean open = true;
    private boolean ended;

    TcpServerLink(SocketChannel channel, String address, Optional<String> team) {
        this.channel = channel;
        this.address = address;
        this.team = team;
    }

    /** Reads one chunk; the rest remains in the socket's buffer. */
    void receive() {
        try {
            if (!ended && decoder.fillFrom(channel) < 0) {
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
        } catch (FrameTooLongException e) {
            end("was disconnected. " + e.getMessage());
            return false;
        }
        if (ended) {
            end(HAS_LEFT);
        }
        return false;
    }

    @Override
    public boolean offer(MessageBuffer message) {
        try {
            return encoder.send(channel, message);
        } catch (IOException e) {
            end("has lost its connection (" + e.getMessage() + ").");
            return false;
        }
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
        return "at " + address;
    }

    @Override
    public Optional<String> team() {
        return team;
    }

    private void end(String reason) {
        if (open) {
            open = false;
            closingReason = reason;
            try {
                channel.close();
            } catch (IOException e) {
                // The connection is being abandoned anyway.
            }
        }
    }
}
