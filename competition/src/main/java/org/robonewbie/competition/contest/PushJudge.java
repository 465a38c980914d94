package org.robonewbie.competition.contest;

import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.simulator.SimulationControl;

/**
 * Pushes the robot every three seconds at its torso for 0.1 s, each time 5 N harder and from another direction, until it has
 * fallen.
 */
final class PushJudge implements Judge {

    static final String STANDING_SECONDS = "standingSeconds";
    static final String PUSHES = "pushes";

    private static final int CYCLES_BETWEEN_PUSHES = 150;
    private static final int CYCLES_OF_A_PUSH = 5;
    private static final double STEP_NEWTONS = 5;

    private final String team;
    private final Random random;
    private final Map<String, Double> figures = new TreeMap<>();
    private int cycle;
    private int pushes;
    private Vector3 push = Vector3.ZERO;

    PushJudge(ContestTrial trial, long seed) {
        this.team = trial.entrants().get(0).team();
        this.random = new Random(seed);
    }

    @Override
    public boolean watch(JudgedMoment moment, SimulationControl referee) {
        List<RobotView> robots = moment.robots(team);
        if (robots.isEmpty() || robots.get(0).isFallen()) {
            return true;
        }
        figures.put(STANDING_SECONDS, moment.seconds());
        figures.put(PUSHES, (double) Math.max(0, pushes - 1));
        cycle++;
        if (cycle % CYCLES_BETWEEN_PUSHES == 0) {
            pushes++;
            double angle = 2 * Math.PI * random.nextDouble();
            push = new Vector3(Math.cos(angle), Math.sin(angle), 0).times(pushes * STEP_NEWTONS);
        }
        if (pushes > 0 && cycle % CYCLES_BETWEEN_PUSHES < CYCLES_OF_A_PUSH) {
            referee.order(new Order.PushRobot(
                    new PlayerNumber(
                            moment.side(team).orElseThrow(), robots.get(0).number()),
                    push));
        }
        return false;
    }

    @Override
    public Map<String, Double> figures(String who) {
        return figures;
    }
}
