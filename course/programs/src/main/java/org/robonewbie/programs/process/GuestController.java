package org.robonewbie.programs.process;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
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
 * Controller that receives its commands from an agent in another process. The agent uses the simulator's protocol, but
 * its commands to create a robot, join a team or beam are ignored, because the trial has already created the robot.
 */
final class GuestController implements Controller {

    private static final int MAX_BYTES = 1 << 20;

    private final SocketChannel channel;
    private final FrameInput input;
    private final FrameOutput output;
    private final EffectorMessageReader reader = new EffectorMessageReader();
    private final MessageBuffer answer = new MessageBuffer();
    private boolean synchronising;

    private GuestController(SocketChannel channel) throws IOException {
        this.channel = channel;
        if (channel.getRemoteAddress() instanceof InetSocketAddress) {
            Socket socket = channel.socket();
            socket.setTcpNoDelay(true);
            input = new FrameInput(socket.getInputStream(), MAX_BYTES);
            output = new FrameOutput(socket.getOutputStream());
        } else {
            input = new FrameInput(Channels.newInputStream(channel), MAX_BYTES);
            output = new FrameOutput(Channels.newOutputStream(channel));
        }
    }

    /** Accepts an agent and reads the message in which it requests a robot. */
    static GuestController welcome(SocketChannel channel) throws IOException {
        GuestController guest = new GuestController(channel);
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
            throw new AbsentProgramException("The program left during the trial.", gone);
        }
    }

    /** Reads the agent's commands for one cycle. If the agent synchronises, the commands end with {@code (syn)}. */
    private List<EffectorCommand> listen() throws IOException {
        List<EffectorCommand> commands = new ArrayList<>();
        boolean complete = false;
        while (!complete) {
            if (!input.read(answer)) {
                throw new AbsentProgramException("The program exited during the trial.");
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
            throw new AbsentProgramException("The connection to the program cannot be closed.", broken);
        }
    }
}
