package org.robonewbie.workshop.load;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;

/**
 * Connection that measures its agent: the processor time between receiving a message and replying to it, and the missed cycles, in which
 * the next message arrived before the reply.
 */
final class ThinkTimes implements AgentLink {

    private final AgentLink link;
    private final int cyclesOfWarmUp;
    private final long[] nanoseconds;
    private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    private long received;
    private int cycles;
    private int missed;

    /** Measures the given number of cycles after a warm-up. */
    ThinkTimes(AgentLink link, int cyclesOfWarmUp, int measuredCycles) {
        this.link = link;
        this.cyclesOfWarmUp = cyclesOfWarmUp;
        this.nanoseconds = new long[measuredCycles];
    }

    @Override
    public boolean receive(MessageBuffer message) throws IOException {
        boolean more = link.receive(message);
        received = threads.getCurrentThreadCpuTime();
        return more;
    }

    @Override
    public void send(MessageBuffer message) throws IOException {
        int measured = cycles++ - cyclesOfWarmUp;
        if (measured >= 0 && measured < nanoseconds.length) {
            nanoseconds[measured] = threads.getCurrentThreadCpuTime() - received;
            missed += link.isMessageWaiting() ? 1 : 0;
        }
        link.send(message);
    }

    @Override
    public boolean isMessageWaiting() throws IOException {
        return link.isMessageWaiting();
    }

    @Override
    public void close() {
        link.close();
    }

    /** Returns the processor time of each measured cycle in nanoseconds. */
    long[] nanoseconds() {
        return Arrays.copyOf(nanoseconds, Math.max(0, Math.min(nanoseconds.length, cycles - cyclesOfWarmUp)));
    }

    int missedCycles() {
        return missed;
    }
}
