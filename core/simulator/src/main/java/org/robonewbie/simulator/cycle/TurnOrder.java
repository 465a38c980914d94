package org.robonewbie.simulator.cycle;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.Predicate;
import org.robonewbie.protocol.effector.EffectorCommand.CreateRobot;
import org.robonewbie.protocol.effector.EffectorCommand.JoinTeam;

/**
 * Makes a game independent of which connection came first, for agents of other processes that the world awaits before it
 * begins: their robots are created sorted by robot type, and once they have said who they are, they are served in the order of
 * their teams' names and numbers.
 *
 * <p>Until then their robots are alike, so that it does not matter whose is whose; each joining agent gets the first one of its
 * type.
 */
final class TurnOrder {

    private static final Comparator<CreateRobot> BY_BUILD =
            Comparator.comparing(CreateRobot::path).thenComparing(create -> String.join(" ", create.parameters()));
    private static final Comparator<JoinTeam> BY_NAME =
            Comparator.comparing(JoinTeam::team).thenComparingInt(JoinTeam::number);

    private TurnOrder() {}

    /**
     * Sorts those who will get a robot or join a team in this cycle.
     *
     * @param agents all agents; changed
     */
    static void arrange(List<AgentSession> agents) {
        if (isNobodyAwaited(agents)) {
            return;
        }
        sort(
                agents,
                agent -> agent.wantedRobot().isPresent(),
                Comparator.comparing(agent -> agent.wantedRobot().orElseThrow(), BY_BUILD));
        List<AgentSession> joining = sort(
                agents,
                agent -> agent.wantedTeam().isPresent() && agent.player().isEmpty(),
                Comparator.comparing(agent -> agent.wantedTeam().orElseThrow(), BY_NAME));
        distributeBodies(joining);
    }

    private static boolean isNobodyAwaited(List<AgentSession> agents) {
        for (int i = 0; i < agents.size(); i++) {
            if (agents.get(i).connection().isAwaited()) {
                return false;
            }
        }
        return true;
    }

    /** Sorts those of interest among themselves; they keep their places in the list as a group. */
    private static List<AgentSession> sort(
            List<AgentSession> agents, Predicate<AgentSession> interest, Comparator<AgentSession> order) {
        List<Integer> places = new ArrayList<>();
        List<AgentSession> sorted = new ArrayList<>();
        for (int i = 0; i < agents.size(); i++) {
            if (agents.get(i).connection().isAwaited() && interest.test(agents.get(i))) {
                places.add(i);
                sorted.add(agents.get(i));
            }
        }
        sorted.sort(order);
        for (int i = 0; i < places.size(); i++) {
            agents.set(places.get(i), sorted.get(i));
        }
        return sorted;
    }

    private static void distributeBodies(List<AgentSession> joining) {
        List<AgentSession.Body> bodies =
                new ArrayList<>(joining.stream().map(AgentSession::body).toList());
        bodies.sort(Comparator.comparingInt(AgentSession.Body::id));
        for (AgentSession agent : joining) {
            AgentSession.Body first = bodies.stream()
                    .filter(body -> body.type() == agent.body().type())
                    .findFirst()
                    .orElseThrow();
            bodies.remove(first);
            agent.setBody(first);
        }
    }
}
