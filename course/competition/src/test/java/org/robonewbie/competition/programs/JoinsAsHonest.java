package org.robonewbie.competition.programs;

import java.io.IOException;
import java.util.List;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.tcp.TcpAgentLink;

/** Brings its own robot, and a second one that calls itself a player of the team "Honest". */
public final class JoinsAsHonest {

    private JoinsAsHonest() {}

    /**
     * Starts both.
     *
     * @param args options of the robot
     */
    public static void main(String[] args) {
        int port = Integer.parseInt(List.of(args).get(List.of(args).indexOf("--port") + 1));
        Stands.beside(args, () -> join(port));
    }

    /** Plays as number 5 of the team until the connection ends; tells on its output how it went. */
    static void join(int port) {
        try (TcpAgentLink link = TcpAgentLink.connect("127.0.0.1", port)) {
            MessageBuffer message = new MessageBuffer();
            send(link, "(scene rsg/agent/nao/nao.rsg)(syn)");
            if (link.receive(message)) {
                send(link, "(init (unum 5)(teamname Honest))(syn)");
            }
            while (link.receive(message)) {
                send(link, "(syn)");
            }
            System.out.println("left " + port);
        } catch (IOException refused) {
            System.out.println("refused " + port);
        }
    }

    private static void send(TcpAgentLink link, String text) throws IOException {
        MessageBuffer message = new MessageBuffer();
        message.append(text);
        link.send(message);
    }
}
