package org.robonewbie.simulator.monitor;

import java.io.IOException;
import java.nio.channels.SelectionKey;
import java.nio.channels.SocketChannel;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.order.TrainerOrderReader;
import org.robonewbie.protocol.tcp.FrameDecoder;
import org.robonewbie.protocol.tcp.FrameEncoder;
import org.robonewbie.protocol.tcp.FrameTooLongException;

/**
 * The simulator's end of a monitor's connection. While a message is being sent, newer ones are dropped; a monitor that has
 * missed a message receives a full one next.
 */
final class MonitorConnection {

    private static final int MAX_COMMAND_BYTES = 1 << 16;

    private final SocketChannel channel;
    private final SelectionKey key;
    private final Consumer<String> console;
    private final FrameDecoder decoder = new FrameDecoder(MAX_COMMAND_BYTES);
    private final FrameEncoder encoder = new FrameEncoder();
    private final TrainerOrderReader reader = new TrainerOrderReader();
    private final MessageBuffer received = new MessageBuffer();
    private boolean upToDate;
    private boolean open = true;

    MonitorConnection(SocketChannel channel, SelectionKey key, Consumer<String> console) {
        this.channel = channel;
        this.key = key;
        this.console = console;
    }

    boolean isOpen() {
        return open;
    }

    /** Returns whether the monitor has received all messages since its first full one. */
    boolean isUpToDate() {
        return upToDate;
    }

    /** Returns whether the previous message has been sent completely. */
    boolean isReady() {
        return !encoder.isPending();
    }

    /** Reads the trainer commands that have arrived. */
    List<Order> receive() {
        List<Order> commands = new ArrayList<>();
        try {
            int count = decoder.fillFrom(channel);
            while (decoder.next(received)) {
                commands.addAll(reader.read(received));
            }
            if (count < 0) {
                close();
            }
        } catch (FrameTooLongException unusable) {
            console.accept("A monitor was disconnected: " + unusable.getMessage());
            close();
        } catch (IOException broken) {
            close();
        }
        return commands;
    }

    /** Sends a message, or drops it if the previous one is still being sent. */
    void send(MessageBuffer message) {
        try {
            upToDate = encoder.send(channel, message);
            updateInterest();
        } catch (IOException broken) {
            close();
        }
    }

    /** Sends more of the pending message. */
    void flush() {
        try {
            encoder.flush(channel);
            updateInterest();
        } catch (IOException broken) {
            close();
        }
    }

    void close() {
        open = false;
        key.cancel();
        try {
            channel.close();
        } catch (IOException broken) {
            // The connection is being abandoned anyway.
        }
    }

    private void updateInterest() {
        key.interestOps(encoder.isPending() ? SelectionKey.OP_READ | SelectionKey.OP_WRITE : SelectionKey.OP_READ);
    }
}
