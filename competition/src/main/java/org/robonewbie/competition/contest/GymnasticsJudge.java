package org.robonewbie.competition.contest;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Predicate;
import org.robonewbie.nao.Joint;
import org.robonewbie.simulator.SimulationControl;

/**
 * Counts which of six elements the robot has shown, in any order: both arms up, a squat, a stand on one leg, a bow, a full turn,
 * and lying down and getting up again.
 */
final class GymnasticsJudge implements Judge {

    static final String ELEMENTS = "elements";
    static final String LAST_SECONDS = "lastSeconds";

    private static final double ARMS_UP_DEGREES = 70;
    private static final double SQUAT_METRES = 0.31;
    private static final double FOOT_METRES = 0.05;
    private static final double BOW_DEGREES = 30;
    private static final double LYING_DEGREES = 75;
    private static final double SECOND = 50;

    private final String team;
    private final List<Held> held = new ArrayList<>();
    private final Held lying = new Held(SECOND, robot -> robot.leanDegrees() > LYING_DEGREES);
    private final Held standing = new Held(SECOND, RobotView::isUpright);
    private final Map<String, Double> figures = new TreeMap<>();
    private double turnedDegrees;
    private double lastHeading = Double.NaN;
    private boolean hasTurned;
    private boolean hasGotUp;

    GymnasticsJudge(ContestTrial trial) {
        team = trial.entrants().get(0).team();
        held.add(new Held(SECOND, robot -> robot.isUpright() && areArmsUp(robot)));
        held.add(new Held(SECOND, robot -> robot.isUpright() && robot.torso().z() < SQUAT_METRES));
        held.add(new Held(2 * SECOND, robot -> robot.isUpright() && footDifference(robot) > FOOT_METRES));
        held.add(new Held(SECOND, GymnasticsJudge::isBowing));
        figures.put(ELEMENTS, 0.0);
    }

    @Override
    public boolean watch(JudgedMoment moment, SimulationControl referee) {
        List<RobotView> robots = moment.robots(team);
        if (robots.isEmpty()) {
            return true;
        }
        RobotView robot = robots.get(0);
        held.forEach(element -> element.watch(robot));
        watchTurn(robot);
        watchGettingUp(robot);
        double shown = held.stream().filter(element -> element.shown).count()
                + (hasTurned ? 1.0 : 0.0)
                + (hasGotUp ? 1.0 : 0.0);
        if (shown > figures.getOrDefault(ELEMENTS, 0.0)) {
            figures.put(ELEMENTS, shown);
            figures.put(LAST_SECONDS, moment.seconds());
        }
        return shown == held.size() + 2.0;
    }

    @Override
    public Map<String, Double> figures(String who) {
        return figures;
    }

    /** Something that has to be held for a while without a break. */
    private static final class Held {

        private final double cycles;
        private final Predicate<RobotView> condition;
        private int count;
        private boolean shown;

        Held(double cycles, Predicate<RobotView> condition) {
            this.cycles = cycles;
            this.condition = condition;
        }

        void watch(RobotView robot) {
            count = condition.test(robot) ? count + 1 : 0;
            shown |= count >= cycles;
        }
    }

    private void watchTurn(RobotView robot) {
        double heading = robot.headingDegrees();
        if (robot.isUpright()) {
            if (!Double.isNaN(lastHeading)) {
                turnedDegrees += Math.IEEEremainder(heading - lastHeading, 360);
            }
            lastHeading = heading;
        } else {
            lastHeading = Double.NaN;
        }
        hasTurned |= Math.abs(turnedDegrees) >= 360;
    }

    private void watchGettingUp(RobotView robot) {
        lying.watch(robot);
        if (lying.shown) {
            standing.watch(robot);
            hasGotUp |= standing.shown;
        }
    }

    private static boolean areArmsUp(RobotView robot) {
        return robot.jointDegrees(Joint.LEFT_SHOULDER_PITCH) > ARMS_UP_DEGREES
                && robot.jointDegrees(Joint.RIGHT_SHOULDER_PITCH) > ARMS_UP_DEGREES;
    }

    private static double footDifference(RobotView robot) {
        return Math.abs(robot.height("lfoot") - robot.height("rfoot"));
    }

    private static boolean isBowing(RobotView robot) {
        return robot.leanDegrees() >= BOW_DEGREES && robot.leanDegrees() < LYING_DEGREES;
    }
}
