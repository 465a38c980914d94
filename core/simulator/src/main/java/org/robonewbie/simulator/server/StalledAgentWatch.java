package org.robonewbie.simulator.server;

import java.util.HashSet;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.cycle.AgentChannel;
import org.robonewbie.simulator.cycle.AgentSession;

/**
 * Reports agents that block sync mode and disconnects those in other processes after a timeout. The timeout for a new
 * agent, which has been responding for less than a simulated second, is about a third of the normal timeout. Whenever a
 * new agent is disconnected, this shorter timeout is halved. A client that reconnects repeatedly therefore delays the
 * other agents only briefly.
 */
final class StalledAgentWatch {

    private static final double SECONDS_UNTIL_REPORTED = 5;

    private static final long ANSWERS_OF_A_NEW_AGENT = 50;
    private static final double NEW_AGENT_SHARE = 0.35;
    private static final double START_UP_SECONDS = 0.5;
    private static final double MIN_SECONDS = 0.1;

    private final Console console;
    private final double timeout;
    private final Set<AgentChannel> reported = new HashSet<>();
    private final Set<String> silentTeams = ConcurrentHashMap.newKeySet();
    private long waitingSince;
    private boolean waiting;
    private double newAgentTimeout;

    StalledAgentWatch(Console console, double timeoutSeconds) {
        this.console = console;
        this.timeout = timeoutSeconds;
        this.newAgentTimeout = Math.max(timeout * NEW_AGENT_SHARE, Math.min(timeout, START_UP_SECONDS));
    }

    /** Restarts the timeout after all agents have answered. */
    void reset() {
        waiting = false;
    }

    /** Checks the timeout of an agent that blocks the simulation. */
    void check(AgentSession agent) {
        long now = System.nanoTime();
        if (!waiting) {
            waiting = true;
            waitingSince = now;
        }
        double seconds = (now - waitingSince) / 1e9;
        boolean local = agent.connection().link().isLocal();
        boolean isNew = isNew(agent.connection());
        double limit = isNew ? newAgentTimeout : timeout;
        if (seconds >= SECONDS_UNTIL_REPORTED && reported.add(agent.connection())) {
            console.say("Waiting for " + agent + ", which has not answered for "
                    + PortableMath.round(SECONDS_UNTIL_REPORTED) + " s."
                    + (local ? "" : " It will be disconnected after " + text(limit) + " s."));
        }
        if (!local && seconds >= limit) {
            console.say("Disconnected " + agent + ", which has not answered for " + text(seconds) + " s.");
            newAgentTimeout = isNew ? Math.max(MIN_SECONDS, newAgentTimeout / 2) : newAgentTimeout;
            agent.connection().link().team().ifPresent(silentTeams::add);
            agent.connection().link().close();
        }
    }

    /** Returns the teams that have an endpoint and have had an agent disconnected. Thread-safe. */
    Set<String> silentTeams() {
        return silentTeams;
    }

    /** Returns whether an agent is new; an agent that uses a team endpoint never is. */
    private static boolean isNew(AgentChannel connection) {
        return connection.link().team().isEmpty() && connection.answeredMessages() < ANSWERS_OF_A_NEW_AGENT;
    }

    private static String text(double seconds) {
        return String.format(Locale.ROOT, seconds < 1 ? "%.1f" : "%.0f", seconds);
    }
}
