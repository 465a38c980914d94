package org.robonewbie.simulator.server;

import java.util.HashSet;
import java.util.Locale;
import java.util.Set;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.cycle.AgentConnection;
import org.robonewbie.simulator.cycle.ConnectedAgent;

/** Reports agents that keep the world waiting in sync mode, and drops those of other processes after some time. */
final class StalledAgentWatch {

    private static final double SECONDS_UNTIL_NAMED = 5;

    private final Console console;
    private final double secondsUntilDropped;
    private final Set<AgentConnection> named = new HashSet<>();
    private long waitingSince;
    private boolean waiting;

    StalledAgentWatch(Console console, double secondsUntilDropped) {
        this.console = console;
        this.secondsUntilDropped = secondsUntilDropped;
    }

    void everybodyAnswered() {
        waiting = false;
    }

    void isWaitingFor(ConnectedAgent agent) {
        long now = System.nanoTime();
        if (!waiting) {
            waiting = true;
            waitingSince = now;
        }
        double seconds = (now - waitingSince) / 1e9;
        boolean local = agent.connection().link().isLocal();
        if (seconds >= SECONDS_UNTIL_NAMED && named.add(agent.connection())) {
            console.say("The world waits for " + agent + ", which has not sent (syn) for "
                    + PortableMath.round(SECONDS_UNTIL_NAMED) + " s."
                    + (local ? "" : " It is dropped after " + text(secondsUntilDropped) + " s."));
        }
        if (!local && seconds >= secondsUntilDropped) {
            console.say("Dropped " + agent + ", which has not sent (syn) for " + text(seconds) + " s.");
            agent.connection().link().close();
        }
    }

    private static String text(double seconds) {
        return String.format(Locale.ROOT, "%.0f", seconds);
    }
}
