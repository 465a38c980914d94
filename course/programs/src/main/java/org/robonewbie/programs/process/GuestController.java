package org.robonewbie.programs.process;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.channels.Channels;
import java.nio.channels.SocketChannel;
import java.util.ArrayList;
import java.util.List;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.effector.EffectorMessageReader;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.tcp.FrameInput;
import org.robonewbie.protocol.tcp.FrameOutput;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.SensorReadings;

/**
 * An agent of another process. It believes to talk with a simulator: it builds a robot, joins a team and takes its place, all of
 * which is read and forgotten, since the trial has let in a robot for it.
 */
final class GuestController implements Controller {

    private static final int MAX_BYTES = 1 << 20;

    private static final int MILLISECONDS_PER_SECOND = 1000;

    private final SocketChannel channel;
    private final double patienceSeconds;
    private final FrameInput input;
    private final FrameOutput output;
    private final EffectorMessageReader reader = new EffectorMessageReader();
    private final MessageBuffer answer = new MessageBuffer();
    private boolean synchronising;

    private GuestController(SocketChannel channel, double patienceSeconds) throws IOException {
        this.channel = channel;
        this.patienceSeconds = patienceSeconds;
        if (channel.getRemoteAddress() instanceof InetSocketAddress) {
            Socket socket = channel.socket();
            socket.setTcpNoDelay(true);
            socket.setSoTimeout((int) (patienceSeconds * MILLISECONDS_PER_SECOND));
            input = new FrameInput(socket.getInputStream(), MAX_BYTES);
            output = new FrameOutput(socket.getOutputStream());
        } else {
            input = new FrameInput(Channels.newInputStream(channel), MAX_BYTES);
            output = new FrameOutput(Channels.newOutputStream(channel));
        }
    }

    /** Admits an agent, and reads its request for a robot. */
    static GuestController welcome(SocketChannel channel, double patienceSeconds) throws IOException {
        GuestController guest = new GuestController(channel, patienceSeconds);
        guest.listen();
        return guest;
    }

    @Override
    public void awake(SensorReadings readings) {
        respond(readings);
    }

    @Override
    public List<EffectorCommand> respond(SensorReadings readings) {
        try {
            output.write(readings.text());
            return listen();
        } catch (IOException gone) {
            throw new AbsentProgramException("The program has gone in the middle of the trial.", gone);
        }
    }

    /** Reads one answer, which for agents that say so ends with {@code (syn)}. */
    private List<EffectorCommand> listen() throws IOException {
        List<EffectorCommand> commands = new ArrayList<>();
        boolean complete = false;
        while (!complete) {
            try {
                if (!input.read(answer)) {
                    throw new AbsentProgramException("The program has ended in the middle of the trial.");
                }
            } catch (SocketTimeoutException silence) {
                throw new AbsentProgramException(
                        "The program gave no answer for " + patienceSeconds + " s. Is there an endless loop?", silence);
            }
            reader.read(answer, commands::add, problem -> {});
            boolean end = commands.stream().anyMatch(EffectorCommand.Synchronise.class::isInstance);
            synchronising |= end;
            complete = end || !synchronising;
        }
        return commands;
    }

    @Override
    public void close() {
        try {
            channel.close();
        } catch (IOException broken) {
            throw new AbsentProgramException("The connection of the program cannot be closed.", broken);
        }
    }
}
