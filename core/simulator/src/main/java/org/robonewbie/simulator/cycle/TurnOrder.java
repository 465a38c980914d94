package org.robonewbie.simulator.cycle;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.Predicate;
import org.robonewbie.protocol.effector.EffectorCommand.CreateRobot;
import org.robonewbie.protocol.effector.EffectorCommand.JoinTeam;

/**
 * A canonical order of the awaited agents in other processes. It makes a game independent of the order in which they
 * connect. Their robots are created in order of robot type; after joining, agents are served in order of team name and
 * uniform number.
 *
 * <p>Before they join, robots of one type are interchangeable. Each joining agent gets the first robot of its type.
 */
final class TurnOrder {

    private static final Comparator<CreateRobot> BY_BUILD =
            Comparator.comparing(CreateRobot::path).thenComparing(create -> String.join(" ", create.parameters()));
    private static final Comparator<JoinTeam> BY_NAME =
            Comparator.comparing(JoinTeam::team).thenComparingInt(JoinTeam::number);

    private TurnOrder() {}

    /**
     * Sorts the agents that get a robot or join a team in this cycle.
     *
     * @param agents all agents; sorted in place
     */
    static void arrange(List<AgentSession> agents) {
        if (!isAnyAwaited(agents)) {
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

    private static boolean isAnyAwaited(List<AgentSession> agents) {
        for (int i = 0; i < agents.size(); i++) {
            if (agents.get(i).connection().isAwaited()) {
                return true;
            }
        }
        return false;
    }

    /** Sorts the selected agents within the list positions that they occupy as a group. */
    private static List<AgentSession> sort(
            List<AgentSession> agents, Predicate<AgentSession> selected, Comparator<AgentSession> order) {
        List<Integer> positions = new ArrayList<>();
        List<AgentSession> sorted = new ArrayList<>();
        for (int i = 0; i < agents.size(); i++) {
            if (agents.get(i).connection().isAwaited() && selected.test(agents.get(i))) {
                positions.add(i);
                sorted.add(agents.get(i));
            }
        }
        sorted.sort(order);
        for (int i = 0; i < positions.size(); i++) {
            agents.set(positions.get(i), sorted.get(i));
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
