package org.robonewbie.exercises;

import java.io.IOException;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.effector.EffectorMessageReader;
import org.robonewbie.protocol.frame.FrameInput;
import org.robonewbie.protocol.frame.FrameOutput;
import org.robonewbie.protocol.frame.MessageBuffer;

/**
 * An agent of another process. It believes to talk with a simulator: it builds a robot, joins a team and takes its place, all of
 * which is read and forgotten, since the exercise has its own robot for it.
 */
final class GuestProgram implements Program {

    private static final int MOST_BYTES = 1 << 20;

    private final Socket socket;
    private final FrameInput input;
    private final FrameOutput output;
    private final EffectorMessageReader reader = new EffectorMessageReader();
    private final MessageBuffer answer = new MessageBuffer();
    private boolean synchronising;

    private GuestProgram(Socket socket) throws IOException {
        this.socket = socket;
        socket.setTcpNoDelay(true);
        input = new FrameInput(socket.getInputStream(), MOST_BYTES);
        output = new FrameOutput(socket.getOutputStream());
    }

    /** Lets an agent in, and hears that it wants a robot. */
    static GuestProgram welcome(Socket socket) throws IOException {
        GuestProgram guest = new GuestProgram(socket);
        guest.listen();
        return guest;
    }

    @Override
    public void introduce(String team, int number, TeamSide side) {
        // it learns team and number from its first message
    }

    @Override
    public void awake(MessageBuffer message) {
        respond(message);
    }

    @Override
    public List<EffectorCommand> respond(MessageBuffer message) {
        try {
            output.write(message);
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
                        "The program gave no answer for " + socket.getSoTimeout() / 1000.0
                                + " s. Is there an endless loop?",
                        silence);
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
            socket.close();
        } catch (IOException broken) {
            throw new AbsentProgramException("The connection of the program cannot be closed.", broken);
        }
    }
}
