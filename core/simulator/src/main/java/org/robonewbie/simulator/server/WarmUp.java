package org.robonewbie.simulator.server;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.BooleanSupplier;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.protocol.effector.EffectorCommand.CreateRobot;
import org.robonewbie.protocol.effector.EffectorMessageWriter;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.tcp.TcpAgentLink;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.soccer.SoccerParameters;

/**
 * A short invisible match at full speed. It lets the JVM compile a simulator that must keep up with the clock from its first cycle on.
 * The players swing their legs and fall over each other as in a real match, since a path that is not taken here is compiled when it is
 * first taken.
 *
 * <pre>{@code
 * WarmUp.run(() -> simulator.connectedAgents() == 0);
 * }</pre>
 */
public final class WarmUp {

    private static final int ROBOTS = 22;
    private static final double SECONDS_BEFORE_KICK_OFF = 2;
    private static final double SECONDS = 15;
    private static final long POLL_MILLISECONDS = 100;

    private WarmUp() {}

    /**
     * Plays the match, which takes some seconds.
     *
     * @param isWanted asked several times a second; false ends the match
     * @throws IOException if the simulator cannot be started
     */
    public static void run(BooleanSupplier isWanted) throws IOException {
        SimulatorSettings settings = SimulatorSettings.league()
                .parameters(SoccerParameters.league()
                        .with("AutomaticKickOff=true")
                        .with("WaitBeforeKickOff=" + SECONDS_BEFORE_KICK_OFF))
                .agentPort(0)
                .synchronous(true)
                .speed(SimulationControl.AS_FAST_AS_POSSIBLE)
                .awaitedAgents(ROBOTS)
                .seconds(OptionalDouble.of(SECONDS))
                .build();
        try (Simulator simulator = Simulator.start(settings, Console.silent())) {
            List<Thread> players = new ArrayList<>();
            for (int i = 0; i < ROBOTS; i++) {
                AgentLink link = TcpAgentLink.connect("127.0.0.1", simulator.agentPort());
                players.add(new Thread(new Player(link, i % 2 == 0 ? "Left" : "Right", i / 2 + 1), "warm-up player"));
            }
            players.forEach(player -> {
                player.setDaemon(true);
                player.start();
            });
            Thread first = players.get(0);
            while (isWanted.getAsBoolean() && first.isAlive()) {
                first.join(POLL_MILLISECONDS);
            }
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    /** A clumsy player in a crowd. */
    private static final class Player implements Runnable {

        private static final int PLAYERS_PER_ROW = 4;
        private static final int CYCLES_BETWEEN_CALLS = 3;
        private static final double DISTANCE_METRES = 0.45;
        private static final double SWING_RADIANS_PER_SECOND = 2.5;
        private static final double STEPS_RADIANS_PER_SECOND = 8;

        private final AgentLink link;
        private final String team;
        private final int number;
        private final MessageBuffer message = new MessageBuffer();
        private final EffectorMessageWriter writer = new EffectorMessageWriter(message);

        Player(AgentLink link, String team, int number) {
            this.link = link;
            this.team = team;
            this.number = number;
        }

        @Override
        public void run() {
            try (link) {
                writer.createRobot(CreateRobot.SCENE_OF_TYPE, List.of(String.valueOf(number % 4)));
                send();
                receive();
                writer.joinTeam(number, team);
                send();
                for (int cycle = 0; receive(); cycle++) {
                    move(cycle);
                    send();
                }
            } catch (IOException | UncheckedIOException theMatchHasEnded) {
                // Nothing is left to do.
            }
        }

        private boolean receive() throws IOException {
            boolean received = link.receive(message);
            message.clear();
            return received;
        }

        private void send() throws IOException {
            writer.synchronise();
            link.send(message);
            message.clear();
        }

        private void move(int cycle) {
            double seconds = cycle * Cycle.SECONDS;
            if (seconds < SECONDS_BEFORE_KICK_OFF && cycle % PLAYERS_PER_ROW == 0) {
                int row = (number - 1) / PLAYERS_PER_ROW;
                int column = (number - 1) % PLAYERS_PER_ROW;
                writer.beam(new Pose2d(-3 - DISTANCE_METRES * row, DISTANCE_METRES * (column - 1.5), 0));
            }
            double swing = SWING_RADIANS_PER_SECOND * PortableMath.sin(STEPS_RADIANS_PER_SECOND * seconds);
            writer.hingeSpeed("lle3", swing).hingeSpeed("rle3", -swing);
            writer.hingeSpeed("lle2", swing / 3).hingeSpeed("rle2", swing / 3);
            writer.hingeSpeed("lae1", -swing / 2).hingeSpeed("rae1", swing / 2);
            writer.hingeSpeed("he1", PortableMath.cos(seconds));
            if (cycle % CYCLES_BETWEEN_CALLS == 0) {
                writer.say(team.charAt(0) + "p" + number + "c" + cycle);
            }
        }
    }
}
