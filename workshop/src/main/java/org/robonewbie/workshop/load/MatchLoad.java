package org.robonewbie.workshop.load;

import java.io.IOException;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.lang.management.MemoryType;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.DoubleSupplier;
import java.util.stream.IntStream;
import org.robonewbie.nao.Cycle;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;
import org.robonewbie.simulator.server.WarmUp;
import org.robonewbie.simulator.soccer.SoccerParameters;

/**
 * Plays complete league matches with many agents over TCP on one server, and measures the cost. The agents and the server share this
 * process.
 *
 * <pre>{@code
 * LoadSettings settings = new LoadSettings(22, 600, 1, true);
 * new MatchLoad(settings, System.out).run().forEach(result -> System.out.println(result.toLine()));
 * }</pre>
 */
public final class MatchLoad {

    private static final double SECONDS_BEFORE_KICK_OFF = 2;
    private static final long POLL_MILLISECONDS = 100;
    private static final double PROGRESS_SECONDS = 30;
    private static final double SECONDS_UNTIL_APART = 10;
    private static final int COLLECTIONS = 4;
    private static final double SILENT_AGENT_SECONDS = 600;

    private final LoadSettings load;
    private final PrintStream progress;

    /**
     * Creates a measurement.
     *
     * @param load the load
     * @param progress destination of the progress messages
     */
    public MatchLoad(LoadSettings load, PrintStream progress) {
        this.load = load;
        this.progress = progress;
    }

    /**
     * Plays the matches. If the server runs in real time, a {@linkplain WarmUp warm-up} precedes them.
     *
     * @return one result per match
     * @throws IOException if the server cannot be started
     */
    public List<MatchLoadResult> run() throws IOException {
        if (load.realTime()) {
            WarmUp.run(() -> true);
        }
        double secondsUntilApart = Math.min(SECONDS_UNTIL_APART, load.secondsOfPlay() / 4);
        List<MatchLoadResult> results = new ArrayList<>();
        try (Simulator simulator = Simulator.start(settings(), Console.silent())) {
            List<LoadPlayer> players = connect(simulator.agentPort());
            LoadPlayer first = players.get(0);
            Course course = new Course(simulator, first);
            await(first::isInTheGame, () -> {});
            for (int match = 1; match <= load.matches(); match++) {
                course.matchBegins();
                awaitEnd(first, course, match);
                results.add(course.result(match, () -> {
                    simulator.control().order(new Order.Reset());
                    await(() -> first.isPlaying() && first.playSeconds() > secondsUntilApart, () -> {});
                    simulator.control().order(new Order.Pause());
                    return heapMegabytes();
                }));
                simulator.control().order(new Order.Resume());
            }
        }
        return results;
    }

    private SimulatorSettings settings() {
        return SimulatorSettings.of(WorldSettings.league()
                        .withParameters(SoccerParameters.league()
                                .with("RuleHalfTime=" + load.secondsOfPlay() / 2)
                                .with("AutomaticKickOff=true")
                                .with("WaitBeforeKickOff=" + SECONDS_BEFORE_KICK_OFF))
                        .withSynchronous(!load.realTime()))
                .withAgents(new SimulatorSettings.Agents(
                        SimulatorSettings.LOCALHOST, 0, List.of(), load.robots(), SILENT_AGENT_SECONDS))
                .withSpeed(load.realTime() ? 1 : SimulationControl.AS_FAST_AS_POSSIBLE);
    }

    private List<LoadPlayer> connect(int port) throws IOException {
        List<LoadPlayer> players = new ArrayList<>();
        for (int i = 0; i < load.robots(); i++) {
            LoadPlayer player = new LoadPlayer(port, i, i == 0);
            player.start();
            players.add(player);
        }
        return players;
    }

    /**
     * Waits for the end of a match. Relies on the player's count of finished matches, because a short match may start and end between two
     * polls.
     */
    private void awaitEnd(LoadPlayer player, Course course, int match) {
        double[] reported = {0};
        await(() -> player.endedMatches() >= match, () -> {
            if (player.isPlaying() && player.playSeconds() >= reported[0] + PROGRESS_SECONDS) {
                reported[0] = player.playSeconds();
                progress.println(String.format(
                        Locale.ROOT,
                        "match %d: %.0f s played, %d cycles missed",
                        match,
                        reported[0],
                        course.missedCycles()));
            }
        });
    }

    private static void await(BooleanSupplier condition, Runnable meanwhile) {
        while (!condition.getAsBoolean()) {
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(POLL_MILLISECONDS));
            meanwhile.run();
        }
    }

    /**
     * Returns the heap in use. Takes the minimum of several collections, because one collection may leave unreachable
     * objects in sparsely filled regions.
     */
    private static double heapMegabytes() {
        return IntStream.range(0, COLLECTIONS)
                .mapToDouble(i -> heapMegabytesAfterCollection())
                .min()
                .orElseThrow();
    }

    /**
     * Returns the heap in use at the end of a collection, which excludes thread-local allocation buffers assigned since
     * then.
     */
    private static double heapMegabytesAfterCollection() {
        ManagementFactory.getMemoryMXBean().gc();
        return ManagementFactory.getMemoryPoolMXBeans().stream()
                .filter(pool -> pool.getType() == MemoryType.HEAP && pool.getCollectionUsage() != null)
                .mapToDouble(pool -> pool.getCollectionUsage().getUsed() / 1e6)
                .sum();
    }

    /** Counters at the start of a match, and their differences at its end. */
    private static final class Course {

        private final Simulator simulator;
        private final LoadPlayer player;
        private double beganSeconds;
        private long beganMissed;
        private double beganServer;
        private double beganProcess;

        Course(Simulator simulator, LoadPlayer player) {
            this.simulator = simulator;
            this.player = player;
        }

        long missedCycles() {
            return simulator.missedCycles() - beganMissed;
        }

        void matchBegins() {
            player.arrivals().restart();
            beganSeconds = simulator.cycles() * Cycle.SECONDS;
            beganMissed = simulator.missedCycles();
            beganServer = simulator.processorSeconds();
            beganProcess = processSeconds();
        }

        /** Ends the measurement. The heap is measured last, because this measurement waits for the next kick-off. */
        MatchLoadResult result(int match, DoubleSupplier heapMegabytes) {
            long cycles = Math.round(simulator.cycles() - beganSeconds / Cycle.SECONDS);
            double server = simulator.processorSeconds() - beganServer;
            double process = processSeconds() - beganProcess;
            return new MatchLoadResult(
                    match,
                    cycles,
                    player.playSeconds(),
                    missedCycles(),
                    1000 * server / cycles,
                    1000 * process / cycles,
                    1000 * player.arrivals().deviationSeconds(0.99),
                    1000 * player.arrivals().deviationSeconds(1),
                    heapMegabytes.getAsDouble());
        }

        private static double processSeconds() {
            return ManagementFactory.getOperatingSystemMXBean()
                            instanceof com.sun.management.OperatingSystemMXBean system
                    ? system.getProcessCpuTime() / 1e9
                    : Double.NaN;
        }
    }
}
