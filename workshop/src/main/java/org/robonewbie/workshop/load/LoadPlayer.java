package org.robonewbie.workshop.load;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.protocol.effector.EffectorCommand.CreateRobot;
import org.robonewbie.protocol.effector.EffectorMessageWriter;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.GameState;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PerceptorMessageReader;
import org.robonewbie.protocol.tcp.TcpAgentLink;

/**
 * One player of a match under load: it takes its place before each kick-off, bends its knees again and again while it swings
 * arms and head, calls to its team, and reads every message. It never falls, so that each robot costs the same all the time.
 */
final class LoadPlayer implements Runnable {

    private static final int TYPES = 4;
    private static final int PLAYERS_PER_ROW = 4;
    private static final double APART_METRES = 4;
    private static final double BEND_RADIANS = Math.toRadians(10);
    private static final double RADIANS_PER_SECOND = 2 * Math.PI / 1.6;
    private static final int CYCLES_BETWEEN_CALLS = 3;

    private final String team;
    private final int number;
    private final boolean isTimed;
    private final AgentLink link;
    private final Arrivals arrivals = new Arrivals();
    private final MessageBuffer message = new MessageBuffer();
    private final EffectorMessageWriter writer = new EffectorMessageWriter(message);
    private final PerceptorMessageReader reader = new PerceptorMessageReader();
    private volatile String playMode = "";
    private volatile double playSeconds;
    private volatile int endedMatches;

    /**
     * Connects a player.
     *
     * @param isTimed whether it keeps the times at which messages come, which takes memory
     */
    LoadPlayer(int port, String team, int number, boolean isTimed) throws IOException {
        this.isTimed = isTimed;
        this.team = team;
        this.number = number;
        this.link = TcpAgentLink.connect("127.0.0.1", port);
    }

    /** The arrival times of the messages. */
    Arrivals arrivals() {
        return arrivals;
    }

    /** Whether the referee has announced a play mode yet. */
    boolean isInTheGame() {
        return !playMode.isEmpty();
    }

    /** Whether a match is running. */
    boolean isPlaying() {
        return isInTheGame() && !playMode.equals(PlayMode.GAME_OVER.simSparkName());
    }

    /** The number of matches that have ended. */
    int endedMatches() {
        return endedMatches;
    }

    /** The game time in seconds. */
    double playSeconds() {
        return playSeconds;
    }

    @Override
    public void run() {
        try (link) {
            writer.createRobot(CreateRobot.SCENE_OF_TYPE, List.of(String.valueOf(number % TYPES)));
            send();
            receive();
            writer.joinTeam(number, team);
            send();
            for (int cycle = 0; receive(); cycle++) {
                move(cycle);
                send();
            }
        } catch (IOException | UncheckedIOException e) {
            // The server has ended.
        }
    }

    private boolean receive() throws IOException {
        if (!link.receive(message)) {
            return false;
        }
        PerceptorMessage felt = reader.read(message);
        if (isTimed) {
            arrivals.add(System.nanoTime(), felt.seconds().orElse(0));
        }
        felt.gameState().ifPresent(this::watch);
        message.clear();
        return true;
    }

    /** The only thread that writes is this player's. */
    @SuppressWarnings("NonAtomicVolatileUpdate")
    private void watch(GameState state) {
        boolean over = state.playModeName().equals(PlayMode.GAME_OVER.simSparkName());
        playSeconds = state.playSeconds();
        if (over && !playMode.equals(state.playModeName())) {
            endedMatches++;
        }
        playMode = state.playModeName();
    }

    private void send() throws IOException {
        writer.synchronise();
        link.send(message);
        message.clear();
    }

    private void move(int cycle) {
        if (playMode.equals(PlayMode.BEFORE_KICK_OFF.simSparkName()) && cycle % PLAYERS_PER_ROW == 0) {
            int row = (number - 1) / PLAYERS_PER_ROW;
            int column = (number - 1) % PLAYERS_PER_ROW;
            writer.beam(new Pose2d(-3 - APART_METRES * row, APART_METRES * (column - 1.5), 0));
        }
        double seconds = cycle * Cycle.SECONDS;
        double bend = BEND_RADIANS / 2 * RADIANS_PER_SECOND * Math.sin(RADIANS_PER_SECOND * seconds);
        for (String side : List.of("l", "r")) {
            writer.hingeSpeed(side + "le3", bend)
                    .hingeSpeed(side + "le4", -2 * bend)
                    .hingeSpeed(side + "le5", bend);
            writer.hingeSpeed(side + "ae1", -bend);
        }
        writer.hingeSpeed("he1", Math.cos(seconds));
        if (cycle % CYCLES_BETWEEN_CALLS == 0) {
            writer.say(team.charAt(0) + "p" + number + "c" + cycle);
        }
    }
}
