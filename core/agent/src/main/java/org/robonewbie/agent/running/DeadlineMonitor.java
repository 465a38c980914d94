package org.robonewbie.agent.running;

import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.robonewbie.agent.cycle.MessagePort;
import org.robonewbie.agent.cycle.RobotRuntime;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.perceptor.PerceptorMessage;

/**
 * Message port that reports cycles that miss the simulator's deadline. A robot that falls behind catches up: it reads
 * all pending messages, but the program responds only to the newest.
 */
public final class DeadlineMonitor implements MessagePort {

    private static final double CYCLE_MILLISECONDS = 20;
    private static final double WARM_UP_SECONDS = 1;
    private static final double SECONDS_BETWEEN_REPORTS = 10;
    private static final double MAX_SECONDS_BEHIND = 0.2;

    private final MessagePort port;
    private final RobotRuntime robot;
    private final Supplier<String> slowPlace;
    private final LongSupplier nanoseconds;
    private final double bornSeconds;
    private long receivedNanos;
    private long cycles;
    private long lateCycles;
    private double clockAheadSeconds = Double.POSITIVE_INFINITY;

    /**
     * Creates a monitor for a port.
     *
     * @param port the monitored port
     * @param robot receives the reports
     * @param slowPlace supplies the file and line at which the robot's program spent its time; may supply an empty
     *     string
     * @param nanoseconds the clock, such as {@link System#nanoTime}
     */
    public DeadlineMonitor(MessagePort port, RobotRuntime robot, Supplier<String> slowPlace, LongSupplier nanoseconds) {
        this.port = port;
        this.robot = robot;
        this.slowPlace = slowPlace;
        this.nanoseconds = nanoseconds;
        this.bornSeconds = robot.sensors().seconds();
    }

    @Override
    public boolean receive() throws IOException {
        boolean received = port.receive();
        double behind = received ? secondsBehind(port.message().seconds()) : 0;
        if (behind > MAX_SECONDS_BEHIND) {
            received = catchUp(behind);
        }
        receivedNanos = nanoseconds.getAsLong();
        cycles++;
        return received;
    }

    /** Returns the delay, in seconds, of the current message relative to the last message that was not late. */
    private double secondsBehind(OptionalDouble messageSeconds) throws IOException {
        if (messageSeconds.isEmpty()) {
            return 0;
        }
        double clockAhead = nanoseconds.getAsLong() / 1e9 - messageSeconds.getAsDouble();
        if (!port.isLate() || clockAheadSeconds == Double.POSITIVE_INFINITY) {
            clockAheadSeconds = clockAhead;
        }
        return clockAhead - clockAheadSeconds;
    }

    /** Updates the sensors from all pending messages except the newest, which the program responds to. */
    private boolean catchUp(double behind) throws IOException {
        int skipped = 0;
        boolean received = true;
        while (received && port.isLate()) {
            robot.perceive(port.message());
            skipped++;
            received = port.receive();
        }
        robot.log().warning("was %.1f s behind the simulator; skipped %d cycles", behind, skipped);
        report(
                "behind",
                "The robot was %.1f s behind the simulator, since its cycles take longer than 20 ms; it skipped %d cycles."
                        + " Compute less in a cycle.",
                behind,
                skipped);
        return received;
    }

    @Override
    public PerceptorMessage message() {
        return port.message();
    }

    @Override
    public void send(List<EffectorCommand> commands) throws IOException {
        double milliseconds = (nanoseconds.getAsLong() - receivedNanos) / 1e6;
        if (milliseconds > CYCLE_MILLISECONDS && port.isLate()) {
            lateCycles++;
            robot.log().warning("cycle %d came late: it took %.0f ms", cycles, milliseconds);
            if (robot.sensors().seconds() - bornSeconds > WARM_UP_SECONDS) {
                report(
                        "late",
                        "Cycle %d took %.0f ms, but the simulator advances after 20 ms; compute less in a cycle, and log"
                                + " instead of printing. Late cycles so far: %d.",
                        cycles,
                        milliseconds,
                        lateCycles);
            }
        }
        port.send(commands);
    }

    @Override
    public void close() {
        port.close();
    }

    /** Reports a problem, at most once every ten seconds for each line of the program. */
    private void report(String kind, String pattern, Object... values) {
        long period = (long) (robot.sensors().seconds() / SECONDS_BETWEEN_REPORTS);
        robot.diagnostics()
                .reportAt(
                        slowPlace.get(),
                        kind + " in period " + period,
                        () -> String.format(Locale.ROOT, pattern, values));
    }
}
