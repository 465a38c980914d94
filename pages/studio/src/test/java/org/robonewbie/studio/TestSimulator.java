package org.robonewbie.studio;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.robonewbie.agent.puppet.RobotPuppetProvider;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.embedded.Puppet;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;
import org.robonewbie.studio.monitor.MonitoredSimulation;

/** A real simulator in real time with puppets that hold a posture. */
final class TestSimulator implements AutoCloseable {

    private static final long TIMEOUT_SECONDS = 120;
    private static final double REAL_TIME = 1;
    private static final double STANDING_HEIGHT = 0.366;
    private static final int CYCLES_TO_TAKE_A_POSTURE = 50;

    private final Simulator simulator;
    private final Semaphore reports = new Semaphore(0);
    private volatile Optional<WorldSnapshot> latest = Optional.empty();

    TestSimulator() {
        this(SimulatorSettings.of(WorldSettings.beginner().withSeed(1)).withAgentPort(0));
    }

    TestSimulator(SimulatorSettings settings) {
        try {
            simulator = Simulator.start(settings, Console.silent());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        control().addObserver(snapshot -> {
            latest = Optional.of(snapshot);
            reports.release();
        });
        awaitTrue(() -> latest.isPresent());
    }

    /** Adds a robot, starts the game and runs in real time. The first robot of all must be one of the left team. */
    TestSimulator withRobot(
            RobotType type,
            TeamSide side,
            int number,
            double x,
            double y,
            double headingDegrees,
            Map<Joint, Double> posture) {
        order(new Order.SetSpeed(SimulationControl.AS_FAST_AS_POSSIBLE));
        String team = side == TeamSide.LEFT ? "Blue_Newbies" : "Orange_Rockets";
        Puppet puppet = new RobotPuppetProvider().start(simulator.connect(), team, number, type.ordinal());
        for (Joint joint : Joint.values()) {
            puppet.hold(joint, posture.getOrDefault(joint, 0.0));
        }
        PlayerNumber player = new PlayerNumber(side, number);
        awaitTrue(() -> plays(player));
        afterCycles(CYCLES_TO_TAKE_A_POSTURE);
        order(new Order.PlaceRobot(player, new Vector3(x, y, STANDING_HEIGHT), headingDegrees));
        order(new Order.ChangePlayMode(PlayMode.PLAY_ON));
        order(new Order.SetSpeed(REAL_TIME));
        awaitTrue(() -> latest().speed() == REAL_TIME);
        return this;
    }

    TestSimulator withRobot() {
        return withRobot(RobotType.TYPE_0, TeamSide.LEFT, 1, -0.8, 0.3, 0, Posture.STANDING);
    }

    private boolean plays(PlayerNumber player) {
        return latest().robots().stream()
                .anyMatch(robot -> robot.number() == player.number()
                        && robot.side().stream().anyMatch(player.side()::equals));
    }

    int agentPort() {
        return simulator.agentPort();
    }

    /** Connects to the monitor port, which the settings must open. */
    MonitoredSimulation watched() throws IOException {
        return MonitoredSimulation.connect("127.0.0.1", simulator.monitorPort().orElseThrow());
    }

    SimulationControl control() {
        return simulator.control();
    }

    void order(Order order) {
        control().order(order);
    }

    WorldSnapshot latest() {
        return latest.orElseThrow();
    }

    /** Waits for some cycles. */
    WorldSnapshot afterCycles(int cycles) {
        long end = latest().cycle() + cycles;
        awaitTrue(() -> latest().cycle() >= end);
        return latest();
    }

    /** Waits until a condition holds, which is evaluated after each report of the simulation. */
    void awaitTrue(BooleanSupplier condition) {
        long deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(TIMEOUT_SECONDS);
        while (!condition.getAsBoolean()) {
            awaitReport(deadline);
        }
    }

    private void awaitReport(long deadline) {
        try {
            if (!reports.tryAcquire(deadline - System.nanoTime(), TimeUnit.NANOSECONDS)) {
                throw new AssertionError("It did not happen within " + TIMEOUT_SECONDS + " s.");
            }
            reports.drainPermits();
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    @Override
    public void close() {
        simulator.close();
    }
}
