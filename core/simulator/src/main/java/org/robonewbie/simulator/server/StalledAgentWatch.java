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
 * Reports agents that keep the world waiting in sync mode, and drops those of other processes after some time. A stranger, who has
 * not yet answered for a second, gets a third of it, and half of that after each stranger that fell silent: whoever comes back again and
 * again costs the others no more than one.
 */
final class StalledAgentWatch {

    private static final double SECONDS_UNTIL_NAMED = 5;

    private static final long ANSWERS_OF_A_STRANGER = 50;
    private static final double SHARE_OF_STRANGERS = 0.35;
    private static final double SECONDS_TO_WAKE_UP = 0.5;
    private static final double MIN_SECONDS = 0.1;

    private final Console console;
    private final double secondsUntilDropped;
    private final Set<AgentChannel> named = new HashSet<>();
    private final Set<String> silentTeams = ConcurrentHashMap.newKeySet();
    private long waitingSince;
    private boolean waiting;
    private double secondsForStrangers;

    StalledAgentWatch(Console console, double secondsUntilDropped) {
        this.console = console;
        this.secondsUntilDropped = secondsUntilDropped;
        this.secondsForStrangers =
                Math.max(secondsUntilDropped * SHARE_OF_STRANGERS, Math.min(secondsUntilDropped, SECONDS_TO_WAKE_UP));
    }

    void everybodyAnswered() {
        waiting = false;
    }

    void isWaitingFor(AgentSession agent) {
        long now = System.nanoTime();
        if (!waiting) {
            waiting = true;
            waitingSince = now;
        }
        double seconds = (now - waitingSince) / 1e9;
        boolean local = agent.connection().link().isLocal();
        boolean stranger = isStranger(agent.connection());
        double patience = stranger ? secondsForStrangers : secondsUntilDropped;
        if (seconds >= SECONDS_UNTIL_NAMED && named.add(agent.connection())) {
            console.say("The world waits for " + agent + ", which has not answered for "
                    + PortableMath.round(SECONDS_UNTIL_NAMED) + " s."
                    + (local ? "" : " It is dropped after " + text(patience) + " s."));
        }
        if (!local && seconds >= patience) {
            console.say("Dropped " + agent + ", which has not answered for " + text(seconds) + " s.");
            secondsForStrangers = stranger ? Math.max(MIN_SECONDS, secondsForStrangers / 2) : secondsForStrangers;
            agent.connection().link().team().ifPresent(silentTeams::add);
            agent.connection().link().close();
        }
    }

    /** Teams with a door of their own of which an agent was dropped; may be called from any thread. */
    Set<String> silentTeams() {
        return silentTeams;
    }

    /** Those who came through the door of a team are known. */
    private static boolean isStranger(AgentChannel connection) {
        return connection.link().team().isEmpty() && connection.answeredMessages() < ANSWERS_OF_A_STRANGER;
    }

    private static String text(double seconds) {
        return String.format(Locale.ROOT, seconds < 1 ? "%.1f" : "%.0f", seconds);
    }
}
