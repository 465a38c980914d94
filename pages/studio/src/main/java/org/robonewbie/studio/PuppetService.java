package org.robonewbie.studio;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.embedded.Puppet;
import org.robonewbie.protocol.embedded.PuppetProvider;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.WorldSnapshot;

/** Manages the puppets: robots that the user controls from the page. They join as ordinary agents. */
final class PuppetService {

    /** Team name of puppets on a side that has no team yet. */
    static final String TEAM = "Puppets";

    private static final int PLAYERS = 11;
    private static final long CYCLES_TO_LINE_UP = 10;
    private static final double METRES_TO_BALL = 0.4;
    private static final double METRES_BETWEEN = 0.5;

    private final SimulationControl simulation;
    private final Optional<PuppetProvider> provider;
    private final Map<PlayerNumber, Puppet> puppets = new ConcurrentHashMap<>();
    /** Puppets that are joining, with the cycle in which each was first seen in the game. */
    private final Map<PlayerNumber, Long> arriving = new ConcurrentHashMap<>();

    /**
     * Creates a service without puppets.
     *
     * @param simulation the world that puppets join
     * @param provider creates puppets; empty if none is available
     */
    PuppetService(SimulationControl simulation, Optional<PuppetProvider> provider) {
        this.simulation = simulation;
        this.provider = provider;
    }

    /** Returns whether puppets can join; trials admit none. */
    boolean isOpen() {
        return provider.isPresent()
                && simulation.hasClock()
                && simulation.trial().isEmpty();
    }

    boolean isPuppet(RobotSnapshot robot) {
        return robot.side()
                .map(side -> puppets.containsKey(new PlayerNumber(side, robot.number())))
                .orElse(false);
    }

    /**
     * Adds a puppet to a team, with the lowest free player number.
     *
     * @return the side and number of the puppet
     * @throws IllegalStateException if no puppet can join; the message gives the reason
     */
    synchronized PlayerNumber add(TeamSide wanted, WorldSnapshot now) {
        TeamSide side = now.teamLeft().isEmpty() ? TeamSide.LEFT : wanted;
        for (int number = 1; number <= PLAYERS; number++) {
            PlayerNumber player = new PlayerNumber(side, number);
            if (!puppets.containsKey(player) && find(now, player).isEmpty()) {
                start(player, teamName(now, side), RobotType.TYPE_0);
                arriving.put(player, Long.MAX_VALUE);
                return player;
            }
        }
        throw new IllegalStateException("This team already has eleven robots. Remove one, or choose the other team.");
    }

    /** Places new puppets behind the ball, within kicking distance, once they have taken their line-up positions. */
    void place(WorldSnapshot now) {
        for (PlayerNumber player : List.copyOf(arriving.keySet())) {
            find(now, player).ifPresent(robot -> {
                long joined = arriving.merge(player, now.cycle(), Math::min);
                if (now.cycle() - joined >= CYCLES_TO_LINE_UP) {
                    arriving.remove(player);
                    simulation.order(new Order.PlaceRobot(player, behindBall(robot, now), headingOf(player)));
                }
            });
        }
    }

    private static double headingOf(PlayerNumber player) {
        return player.side() == TeamSide.LEFT ? 0 : 180;
    }

    /**
     * Returns the closest free position directly behind the ball, on the side away from the goal that the robot
     * attacks.
     */
    private static Vector3 behindBall(RobotSnapshot robot, WorldSnapshot now) {
        Vector3 ball = now.ballPosition();
        double backwards = robot.side().equals(Optional.of(TeamSide.LEFT)) ? -1 : 1;
        double metres = METRES_TO_BALL;
        while (isTaken(ball.x() + backwards * metres, ball.y(), robot, now)) {
            metres += METRES_BETWEEN;
        }
        return new Vector3(
                ball.x() + backwards * metres, ball.y(), robot.body().position().z());
    }

    private static boolean isTaken(double x, double y, RobotSnapshot robot, WorldSnapshot now) {
        return now.robots().stream()
                .filter(other -> other.id() != robot.id())
                .map(other -> other.body().position())
                .anyMatch(place -> place.minus(new Vector3(x, y, place.z())).length() < METRES_BETWEEN);
    }

    /**
     * Adds a puppet for each robot that appears in {@code state} but is no longer in the game. Returns the number of such
     * robots.
     */
    synchronized int fillUp(WorldSnapshot state, WorldSnapshot now) {
        int missing = 0;
        for (RobotSnapshot robot : state.robots()) {
            Optional<PlayerNumber> player =
                    robot.side().filter(side -> robot.number() > 0).map(side -> new PlayerNumber(side, robot.number()));
            if (player.isPresent() && find(now, player.get()).isEmpty()) {
                missing++;
                standIn(player.get(), robot, now);
            }
        }
        return missing;
    }

    private void standIn(PlayerNumber player, RobotSnapshot robot, WorldSnapshot now) {
        boolean leftComesFirst =
                player.side() == TeamSide.RIGHT && now.teamLeft().isEmpty();
        if (isOpen() && !puppets.containsKey(player) && !leftComesFirst) {
            start(player, teamName(now, player.side(), robot.team()), robot.type());
        }
    }

    void remove(PlayerNumber player) {
        arriving.remove(player);
        Optional.ofNullable(puppets.remove(player)).ifPresent(Puppet::close);
    }

    Puppet puppet(PlayerNumber player) {
        return Optional.ofNullable(puppets.get(player))
                .orElseThrow(() -> new IllegalStateException(
                        "This robot is controlled by a program. Only puppets can be controlled manually."));
    }

    void close() {
        puppets.values().forEach(Puppet::close);
        puppets.clear();
    }

    private void start(PlayerNumber player, String team, RobotType type) {
        PuppetProvider maker = provider.orElseThrow(() -> new IllegalStateException(
                "Puppets are not available: robonewbie-agent is missing from the class path."));
        AgentLink link = simulation
                .connect()
                .orElseThrow(
                        () -> new IllegalStateException("Puppets cannot join a server that runs in another process."));
        puppets.put(player, maker.start(link, team, player.number(), type.ordinal()));
    }

    private static Optional<RobotSnapshot> find(WorldSnapshot now, PlayerNumber player) {
        return now.robots().stream()
                .filter(robot -> robot.number() == player.number()
                        && robot.side().filter(player.side()::equals).isPresent())
                .findFirst();
    }

    private static String teamName(WorldSnapshot now, TeamSide side) {
        return teamName(now, side, side == TeamSide.LEFT || !now.teamLeft().equals(TEAM) ? TEAM : "Other " + TEAM);
    }

    private static String teamName(WorldSnapshot now, TeamSide side, String otherwise) {
        String name = side == TeamSide.LEFT ? now.teamLeft() : now.teamRight();
        return name.isEmpty() ? otherwise.replace(' ', '_') : name;
    }
}
