package org.robonewbie.competition.trial;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.ToIntFunction;
import org.robonewbie.competition.contest.ContestTrial;
import org.robonewbie.competition.contest.Entrant;
import org.robonewbie.competition.contest.Judge;
import org.robonewbie.competition.contest.StartPlace;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.WorldSnapshot;

/**
 * Supervises a trial on the simulation thread: waits for the robots, enforces their start poses, calls the judge in each cycle,
 * and pauses the world in the cycle in which the trial is decided.
 */
final class TrialSupervisor implements SimulationObserver {

    private static final long CYCLES_TO_TAKE_PLACES = 25;
    private static final long CYCLES_TO_JOIN = 150;

    /** Number of cycles for which a team may have too many robots, because a reconnecting program briefly has two. */
    private static final int EXTRA_ROBOT_CYCLES = 10;

    private static final double PLACE_METRES = 0.4;

    private final ContestTrial trial;
    private final Judge judge;
    private final SimulationControl control;
    private final ToIntFunction<String> connectedRobots;
    private final Set<String> intruders;
    private final CountDownLatch decided = new CountDownLatch(1);
    private final TreeSet<String> teamsWithTooManyRobots = new TreeSet<>();
    private final Map<String, Integer> robots = new TreeMap<>();
    private final Map<String, Integer> crowdedCycles = new TreeMap<>();
    private long lastCycle;
    private long complete;
    private long beginning;
    private double seconds;

    /**
     * Creates a supervisor.
     *
     * @param connectedRobots returns the number of robots connected to a team's port, including robots that are not
     *     playing
     * @param intruders teams whose programs connected to another team's port
     */
    TrialSupervisor(
            ContestTrial trial,
            Judge judge,
            SimulationControl control,
            ToIntFunction<String> connectedRobots,
            Set<String> intruders) {
        this.connectedRobots = connectedRobots;
        this.intruders = intruders;
        this.trial = trial;
        this.judge = judge;
        this.control = control;
    }

    @Override
    public void cycleEnded(WorldSnapshot world) {
        if (world.cycle() == lastCycle || isDecided()) {
            return;
        }
        lastCycle = world.cycle();
        if (beginning == 0) {
            lineUp(world);
        } else {
            watch(world);
        }
    }

    boolean isDecided() {
        return decided.getCount() == 0;
    }

    /** Waits until the trial is decided; returns false on timeout. */
    boolean await(long milliseconds) throws InterruptedException {
        return decided.await(milliseconds, TimeUnit.MILLISECONDS);
    }

    /** Returns the simulated time in seconds from the start until the trial was decided. */
    double seconds() {
        return seconds;
    }

    /** Returns whether a team had a robot on the pitch when the trial was decided. */
    boolean isPresent(String team) {
        return robots.getOrDefault(team, 0) > 0;
    }

    /** Returns whether a team had more robots than allowed. */
    boolean hasTooManyRobots(String team) {
        return teamsWithTooManyRobots.contains(team);
    }

    private void lineUp(WorldSnapshot world) {
        long joined = trial.entrants().stream()
                .mapToInt(entrant -> Math.min(
                        entrant.places().size(), robotsOf(entrant, world).size()))
                .sum();
        if (joined >= trial.robots() && complete == 0) {
            complete = world.cycle();
        }
        boolean ready = complete > 0 && world.cycle() >= complete + CYCLES_TO_TAKE_PLACES;
        if (ready || world.cycle() >= CYCLES_TO_JOIN) {
            beginning = world.cycle();
            count(world);
            if (joined == 0) {
                decide(0);
                return;
            }
            if (!trial.ownPlaces()) {
                trial.entrants().forEach(entrant -> correctPlaces(entrant, world));
            }
            kickOff(world);
        }
    }

    private void kickOff(WorldSnapshot world) {
        control.order(new Order.KickOff(trial.kickOff()));
        if (trial.ball().isPresent()) {
            String first = trial.entrants().get(0).team();
            Vector3 ball = trial.ball().get();
            control.order(new Order.ChangePlayMode(PlayMode.PLAY_ON));
            control.order(new Order.MoveBall(
                    world.teamRight().equals(first) ? new Vector3(-ball.x(), -ball.y(), ball.z()) : ball,
                    Vector3.ZERO));
        }
    }

    /** Moves robots that have beamed elsewhere to their start poses. */
    private void correctPlaces(Entrant entrant, WorldSnapshot world) {
        for (RobotSnapshot robot : robotsOf(entrant, world)) {
            TeamSide side = robot.side().orElseThrow();
            StartPlace place = entrant.places().stream()
                    .filter(candidate -> candidate.number() == robot.number())
                    .findFirst()
                    .orElse(entrant.places().get(0));
            Vector3 wanted = place.position(side);
            boolean isThere = Math.hypot(
                            robot.body().position().x() - wanted.x(),
                            robot.body().position().y() - wanted.y())
                    < PLACE_METRES;
            if (!isThere) {
                control.order(
                        new Order.PlaceRobot(new PlayerNumber(side, robot.number()), wanted, place.heading(side)));
            }
        }
    }

    private void watch(WorldSnapshot world) {
        double now = (world.cycle() - beginning) * Cycle.SECONDS;
        count(world);
        if (judge.watch(world)
                || now >= trial.seconds() - 1e-9
                || !teamsWithTooManyRobots.isEmpty()
                || !intruders.isEmpty()) {
            decide(now);
        }
    }

    private void count(WorldSnapshot world) {
        for (Entrant entrant : trial.entrants()) {
            int count = robotsOf(entrant, world).size();
            robots.put(entrant.team(), count);
            boolean tooMany = connectedRobots.applyAsInt(entrant.team())
                    > entrant.places().size();
            crowdedCycles.merge(entrant.team(), 1, (before, one) -> tooMany ? before + one : 0);
            if (count > entrant.places().size() || crowdedCycles.getOrDefault(entrant.team(), 0) > EXTRA_ROBOT_CYCLES) {
                teamsWithTooManyRobots.add(entrant.team());
            }
        }
    }

    private static List<RobotSnapshot> robotsOf(Entrant entrant, WorldSnapshot world) {
        return world.robots().stream()
                .filter(robot -> robot.team().equals(entrant.team()))
                .toList();
    }

    private void decide(double now) {
        seconds = now;
        control.order(new Order.Pause());
        decided.countDown();
    }
}
