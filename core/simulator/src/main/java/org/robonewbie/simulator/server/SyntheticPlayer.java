package org.robonewbie.simulator.server;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.protocol.effector.EffectorCommand.CreateRobot;
import org.robonewbie.protocol.effector.EffectorMessageWriter;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.tcp.TcpAgentLink;

/**
 * A synthetic client for warm-ups and load tests. It joins over TCP, beams to its position in a grid before kick-off, and
 * then moves in a fixed pattern and says a message every third cycle until the server closes the connection.
 */
public abstract class SyntheticPlayer implements Runnable {

    private static final int TYPES = 4;
    private static final int PLAYERS_PER_ROW = 4;
    private static final int CYCLES_BETWEEN_CALLS = 3;

    private final String team;
    private final int number;
    private final double spacingMetres;
    private final AgentLink link;
    private final MessageBuffer message = new MessageBuffer();
    private final EffectorMessageWriter writer = new EffectorMessageWriter(message);

    /**
     * Connects a player; call {@link #run} to play.
     *
     * @param port agent port on this computer
     * @param index index among all players, which alternate between two teams
     * @param spacingMetres distance between players in the grid
     * @throws IOException if the connection fails
     */
    protected SyntheticPlayer(int port, int index, double spacingMetres) throws IOException {
        this.team = index % 2 == 0 ? "Left" : "Right";
        this.number = index / 2 + 1;
        this.spacingMetres = spacingMetres;
        this.link = TcpAgentLink.connect(SimulatorSettings.LOCALHOST, port);
    }

    /**
     * Starts a daemon thread for the player.
     *
     * @return the thread, which ends when the server closes the connection
     */
    public final Thread start() {
        Thread thread = new Thread(this, "player " + number + " of " + team);
        thread.setDaemon(true);
        thread.start();
        return thread;
    }

    @Override
    public final void run() {
        try (link) {
            writer.createRobot(CreateRobot.SCENE_OF_TYPE, List.of(String.valueOf(number % TYPES)));
            send();
            receive();
            writer.joinTeam(number, team);
            send();
            for (int cycle = 0; receive(); cycle++) {
                act(cycle);
                send();
            }
        } catch (IOException | UncheckedIOException e) {
            // The server has closed the connection.
        }
    }

    private boolean receive() throws IOException {
        if (!link.receive(message)) {
            return false;
        }
        received(message);
        message.clear();
        return true;
    }

    private void send() throws IOException {
        writer.synchronise();
        link.send(message);
        message.clear();
    }

    private void act(int cycle) {
        double seconds = cycle * Cycle.SECONDS;
        if (isBeforeKickOff(seconds) && cycle % PLAYERS_PER_ROW == 0) {
            int row = (number - 1) / PLAYERS_PER_ROW;
            int column = (number - 1) % PLAYERS_PER_ROW;
            writer.beam(new Pose2d(-3 - spacingMetres * row, spacingMetres * (column - 1.5), 0));
        }
        move(writer, seconds);
        writer.hingeSpeed("he1", PortableMath.cos(seconds));
        if (cycle % CYCLES_BETWEEN_CALLS == 0) {
            writer.say(team.charAt(0) + "p" + number + "c" + cycle);
        }
    }

    /**
     * Called for each message from the server.
     *
     * @param perceptors the perceptor message
     */
    protected void received(MessageBuffer perceptors) {}

    /**
     * Returns whether the match has not started yet, so the player must still beam to its position.
     *
     * @param seconds simulated seconds since the player joined
     * @return whether to beam instead of moving
     */
    protected abstract boolean isBeforeKickOff(double seconds);

    /**
     * Writes the motor speeds of a cycle.
     *
     * @param commands receives the speeds
     * @param seconds simulated seconds since the player joined
     */
    protected abstract void move(EffectorMessageWriter commands, double seconds);
}
