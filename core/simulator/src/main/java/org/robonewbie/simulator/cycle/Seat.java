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
 * Who an agent was when the world was saved.
 *
 * @param id number of its robot, 0 before it had one
 * @param team name of its team, empty before it had joined one
 * @param number its number in the team
 */
record Seat(int id, String team, int number) {

    /**
     * The rules by which a seat finds its agent, the strictest one first: the same player, the same robot as long as one of the
     * two has not joined, a newcomer without robot, and anybody for a seat of a newcomer.
     */
    private static final List<BiPredicate<Seat, ConnectedAgent>> RULES = List.of(
            (seat, agent) -> seat.isPlayer() && of(agent).isSamePlayer(seat),
            (seat, agent) -> seat.id > 0
                    && seat.id == agent.id()
                    && !(seat.isPlayer() && agent.player().isPresent()),
            (seat, agent) -> agent.robot().isEmpty(),
            (seat, agent) -> seat.id == 0);

    static Seat of(ConnectedAgent agent) {
        return new Seat(
                agent.id(),
                agent.player().map(player -> player.team().name()).orElse(""),
                agent.player().map(Player::number).orElse(0));
    }

    static void saveAll(List<ConnectedAgent> agents, List<Robot> robots, Match match, StateWriter out) {
        out.putAll(agents, agent -> of(agent).save(out));
        agents.forEach(agent -> agent.save(out, robots, match.teams().players()));
    }

    /**
     * Gives all agents back what was saved of them.
     *
     * @param agents who is there now; becomes who was there then, and after them those who had no place
     * @param robots the robots of the world, restored already
     * @param match the game, restored already
     * @param newCamera makes eyes for a robot that had none
     * @param absent stands in for an agent that is not there
     * @param in holds the state of the agents
     */
    static void restoreAll(
            List<ConnectedAgent> agents,
            List<Robot> robots,
            Match match,
            Supplier<Camera> newCamera,
            Supplier<ConnectedAgent> absent,
            StateReader in) {
        List<Seat> seats = in.getAll(() -> restore(in));
        List<ConnectedAgent> present = new ArrayList<>(agents);
        agents.clear();
        agents.addAll(List.of(fill(seats, present, absent)));
        agents.forEach(agent -> agent.restore(in, robots, match.teams().players(), newCamera));
        present.forEach(ConnectedAgent::loseRobot);
        agents.addAll(present);
    }

    private static Seat restore(StateReader in) {
        return new Seat(in.getInt(), in.getText(), in.getInt());
    }

    private void save(StateWriter out) {
        out.putInt(id);
        out.putText(team);
        out.putInt(number);
    }

    /**
     * Finds an agent for each seat.
     *
     * @param seats who was there
     * @param agents who is there now; those that get a seat are taken out
     * @param absent stands in for an agent that is not there
     * @return the agents of the seats, in their order
     */
    private static ConnectedAgent[] fill(
            List<Seat> seats, List<ConnectedAgent> agents, Supplier<ConnectedAgent> absent) {
        ConnectedAgent[] found = new ConnectedAgent[seats.size()];
        for (BiPredicate<Seat, ConnectedAgent> rule : RULES) {
            for (int i = 0; i < found.length; i++) {
                Seat seat = seats.get(i);
                if (found[i] == null) {
                    found[i] = agents.stream()
                            .filter(agent -> rule.test(seat, agent))
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

    private boolean isSamePlayer(Seat other) {
        return team.equals(other.team) && number == other.number;
    }
}
