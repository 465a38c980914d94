package org.robonewbie.simulator.server;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.protocol.effector.EffectorMessageWriter;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.soccer.SoccerParameters;

/**
 * A JIT warm-up for simulators that must keep up with real time from the first cycle: a short hidden match at full
 * speed. Its players swing their legs and fall over each other, so that the code paths of a real match are compiled.
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
     * Plays the match, which takes several seconds.
     *
     * @param isNeeded polled several times per second; false ends the match
     * @throws IOException if the simulator cannot be started
     */
    public static void run(BooleanSupplier isNeeded) throws IOException {
        SimulatorSettings settings = SimulatorSettings.of(WorldSettings.league()
                        .withParameters(SoccerParameters.league()
                                .with("AutomaticKickOff=true")
                                .with("WaitBeforeKickOff=" + SECONDS_BEFORE_KICK_OFF)))
                .withAgentPort(0)
                .withSpeed(SimulationControl.AS_FAST_AS_POSSIBLE)
                .withAwaitedAgents(ROBOTS)
                .withSeconds(SECONDS);
        try (Simulator simulator = Simulator.start(settings, Console.silent())) {
            List<Player> players = new ArrayList<>();
            for (int i = 0; i < ROBOTS; i++) {
                players.add(new Player(simulator.agentPort(), i));
            }
            Thread first = players.stream().map(SyntheticPlayer::start).toList().get(0);
            while (isNeeded.getAsBoolean() && first.isAlive()) {
                first.join(POLL_MILLISECONDS);
            }
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    private static final class Player extends SyntheticPlayer {

        private static final double SPACING_METRES = 0.45;
        private static final double SWING_RADIANS_PER_SECOND = 2.5;
        private static final double STEPS_RADIANS_PER_SECOND = 8;

        Player(int port, int index) throws IOException {
            super(port, index, SPACING_METRES);
        }

        @Override
        protected boolean isBeforeKickOff(double seconds) {
            return seconds < SECONDS_BEFORE_KICK_OFF;
        }

        @Override
        protected void move(EffectorMessageWriter commands, double seconds) {
            double swing = SWING_RADIANS_PER_SECOND * PortableMath.sin(STEPS_RADIANS_PER_SECOND * seconds);
            commands.hingeSpeed("lle3", swing).hingeSpeed("rle3", -swing);
            commands.hingeSpeed("lle2", swing / 3).hingeSpeed("rle2", swing / 3);
            commands.hingeSpeed("lae1", -swing / 2).hingeSpeed("rae1", swing / 2);
        }
    }
}
