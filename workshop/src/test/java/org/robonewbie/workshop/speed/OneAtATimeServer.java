package org.robonewbie.workshop.speed;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.nio.channels.Channels;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.tcp.FrameInput;
import org.robonewbie.protocol.tcp.FrameOutput;

/**
 * Stands in for rcssserver3d in sync mode: it looks for new connections only between two cycles, takes one of them when the one before is in its
 * team, sends it the first message two cycles later, says once in which team it is, and waits for the answer of each.
 */
final class OneAtATimeServer implements AutoCloseable {

    private static final Pattern JOINING = Pattern.compile("\\(init \\(unum (\\d+)\\)\\(teamname (\\w+)\\)\\)");
    private static final int CYCLES_TO_CREATE = 2;

    private final ServerSocketChannel agents = ServerSocketChannel.open();
    private final ServerSocket trainers = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
    private final List<Client> clients = new ArrayList<>();
    private final int room;
    private final int cycles;
    private final Thread thread = new Thread(this::run, "stand-in for rcssserver3d");

    private static final class Client {

        private final SocketChannel channel;
        private final FrameInput input;
        private final FrameOutput output;
        private int age;
        private boolean inTeam;

        Client(SocketChannel channel) throws IOException {
            this.channel = channel;
            channel.configureBlocking(true);
            input = new FrameInput(Channels.newInputStream(channel), 1 << 16);
            output = new FrameOutput(Channels.newOutputStream(channel));
        }
    }

    /**
     * Opens the ports.
     *
     * @param room for so many robots, others stay without a team
     * @param cycles after which it stops to send, without a word
     */
    OneAtATimeServer(int room, int cycles) throws IOException {
        this.room = room;
        this.cycles = cycles;
        agents.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
        thread.start();
    }

    ServerAddress address() throws IOException {
        int port = ((InetSocketAddress) agents.getLocalAddress()).getPort();
        return new ServerAddress("127.0.0.1", port, trainers.getLocalPort(), OptionalLong.empty());
    }

    private void run() {
        try {
            for (int cycle = 0; cycle < cycles; cycle++) {
                admit();
                for (Client client : clients) {
                    answer(client);
                }
            }
        } catch (IOException closed) {
            // the end of the test
        }
    }

    /** Waits for the first robot; afterwards the world does not wait for newcomers. */
    private void admit() throws IOException {
        if (clients.isEmpty() || clients.get(clients.size() - 1).age > CYCLES_TO_CREATE + 3) {
            agents.configureBlocking(clients.isEmpty());
            SocketChannel newcomer = agents.accept();
            if (newcomer != null) {
                clients.add(new Client(newcomer));
            }
        }
    }

    private void answer(Client client) throws IOException {
        client.age++;
        if (client.age == 1 || client.age > CYCLES_TO_CREATE + 1) {
            receive(client);
        }
        if (client.age > CYCLES_TO_CREATE) {
            MessageBuffer message = new MessageBuffer();
            message.append("(time (now " + client.age * 0.02 + "))(GS " + (client.inTeam ? "(unum 1) (team left) " : "")
                    + "(sl 0) (sr 0) (t 0.00) (pm BeforeKickOff))");
            client.output.write(message);
            client.inTeam = false;
        }
    }

    private void receive(Client client) throws IOException {
        MessageBuffer message = new MessageBuffer();
        if (!client.input.read(message)) {
            throw new IOException("An agent has gone.");
        }
        Matcher joining = JOINING.matcher(message.toString());
        client.inTeam = joining.find() && clients.indexOf(client) < room;
    }

    @Override
    public void close() throws IOException {
        agents.close();
        trainers.close();
        for (Client client : List.copyOf(clients)) {
            client.channel.close();
        }
        thread.interrupt();
    }
}
