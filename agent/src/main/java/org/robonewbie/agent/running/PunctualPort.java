package org.robonewbie.agent.running;

import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.robonewbie.agent.cycle.Clockwork;
import org.robonewbie.agent.cycle.LinkPort;
import org.robonewbie.agent.cycle.MessagePort;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.perceptor.PerceptorMessage;

/** Reports answers for which the simulator has not waited. */
public final class PunctualPort implements MessagePort {

    private static final double CYCLE_MILLISECONDS = 20;
    private static final double WARM_UP_SECONDS = 1;
    private static final double SECONDS_BETWEEN_REPORTS = 10;

    private final LinkPort port;
    private final Clockwork robot;
    private final Supplier<String> slowPlace;
    private final LongSupplier nanoseconds;
    private final double bornSeconds;
    private long receivedNanos;
    private long cycles;
    private long lateCycles;

    /**
     * Watches over a port.
     *
     * @param port the port
     * @param robot takes the reports
     * @param slowPlace file and line where the robot's program spent its time; may be empty
     * @param nanoseconds the clock, as {@link System#nanoTime}
     */
    public PunctualPort(LinkPort port, Clockwork robot, Supplier<String> slowPlace, LongSupplier nanoseconds) {
        this.port = port;
        this.robot = robot;
        this.slowPlace = slowPlace;
        this.nanoseconds = nanoseconds;
        this.bornSeconds = robot.senses().seconds();
    }

    @Override
    public boolean receive() throws IOException {
        boolean received = port.receive();
        receivedNanos = nanoseconds.getAsLong();
        cycles++;
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
            if (robot.senses().seconds() - bornSeconds > WARM_UP_SECONDS) {
                report(milliseconds);
            }
        }
        port.send(commands);
    }

    @Override
    public void close() {
        port.close();
    }

    /** Reports a late cycle, at most once in ten seconds for the same line of the program. */
    private void report(double milliseconds) {
        long period = (long) (robot.senses().seconds() / SECONDS_BETWEEN_REPORTS);
        robot.mistakes()
                .reportAt(
                        slowPlace.get(),
                        "late in period " + period,
                        () -> String.format(
                                Locale.ROOT,
                                "Cycle %d took %.0f ms, but the simulator waits only 20 ms and has gone on; compute less"
                                        + " in a cycle, and log instead of printing. Late cycles so far: %d.",
                                cycles,
                                milliseconds,
                                lateCycles));
    }
}
