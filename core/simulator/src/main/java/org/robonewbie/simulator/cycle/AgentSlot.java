package org.robonewbie.simulator.cycle;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BiPredicate;
import java.util.function.Supplier;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.simulator.sensing.Camera;
import org.robonewbie.simulator.soccer.Match;
import org.robonewbie.simulator.soccer.Player;
import org.robonewbie.simulator.world.Robot;

/**
 * The identity of an agent in a saved state.
 *
 * @param id id of its robot, 0 if it has no robot
 * @param team name of its team, empty if it has no team
 * @param number uniform number
 */
record AgentSlot(int id, String team, int number) {

    /**
     * Rules that match agents to slots, strictest first: the same player; the same robot, unless both have joined a team; an
     * agent without a robot; any agent for a slot without a robot.
     */
    private static final List<BiPredicate<AgentSlot, AgentSession>> RULES = List.of(
            (slot, agent) -> slot.isPlayer() && of(agent).isSamePlayer(slot),
            (slot, agent) -> slot.id > 0
                    && slot.id == agent.id()
                    && !(slot.isPlayer() && agent.player().isPresent()),
            (slot, agent) -> agent.robot().isEmpty(),
            (slot, agent) -> slot.id == 0);

    static AgentSlot of(AgentSession agent) {
        return new AgentSlot(
                agent.id(),
                agent.player().map(player -> player.team().name()).orElse(""),
                agent.player().map(Player::number).orElse(0));
    }

    static void saveAll(List<AgentSession> agents, List<Robot> robots, Match match, StateWriter out) {
        out.putAll(agents, agent -> of(agent).save(out));
        agents.forEach(agent -> agent.save(out, robots, match.teams().players()));
    }

    /**
     * Restores the state of all agents. Call after the robots and the match have been restored.
     *
     * @param agents the connected agents; on return, the saved agents in their saved order, followed by the agents
     *     without a slot
     * @param newCamera creates the camera of a robot that had none
     * @param absent creates the placeholder for an agent that is not connected
     */
    static void restoreAll(
            List<AgentSession> agents,
            List<Robot> robots,
            Match match,
            Supplier<Camera> newCamera,
            Supplier<AgentSession> absent,
            StateReader in) {
        List<AgentSlot> slots = in.getAll(() -> restore(in));
        List<AgentSession> present = new ArrayList<>(agents);
        agents.clear();
        agents.addAll(List.of(fill(slots, present, absent)));
        agents.forEach(agent -> agent.restore(in, robots, match.teams().players(), newCamera));
        present.forEach(AgentSession::loseRobot);
        agents.addAll(present);
    }

    private static AgentSlot restore(StateReader in) {
        return new AgentSlot(in.getInt(), in.getText(), in.getInt());
    }

    private void save(StateWriter out) {
        out.putInt(id);
        out.putText(team);
        out.putInt(number);
    }

    /** Assigns an agent to each slot and removes the assigned agents from the list. */
    private static AgentSession[] fill(
            List<AgentSlot> slots, List<AgentSession> agents, Supplier<AgentSession> absent) {
        AgentSession[] found = new AgentSession[slots.size()];
        for (BiPredicate<AgentSlot, AgentSession> rule : RULES) {
            for (int i = 0; i < found.length; i++) {
                AgentSlot slot = slots.get(i);
                if (found[i] == null) {
                    found[i] = agents.stream()
                            .filter(agent -> rule.test(slot, agent))
                            .findFirst()
                            .orElse(null);
                    agents.remove(found[i]);
                }
            }
        }
        for (int i = 0; i < found.length; i++) {
            found[i] = found[i] == null ? absent.get() : found[i];
        }
        return found;
    }

    private boolean isPlayer() {
        return !team.isEmpty();
    }

    private boolean isSamePlayer(AgentSlot other) {
        return team.equals(other.team) && number == other.number;
    }
}
