package org.robonewbie.competition.contest;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.SimulationControl;

/**
 * Measures the longest kick: the straight-line distance of the ball from the place where it left the robot. It has left the
 * robot when it is farther than 0.35 m from the robot's torso; so a ball that is pushed along gains nothing.
 */
final class KickJudge implements Judge {

    static final String KICK_METRES = "kickMetres";

    private static final double AT_ROBOT_METRES = 0.35;

    private final String team;
    private final Map<String, Double> figures = new TreeMap<>();
    private Vector3 left = Vector3.ZERO;

    KickJudge(ContestTrial trial) {
        this.team = trial.entrants().get(0).team();
    }

    @Override
    public boolean watch(JudgedMoment moment, SimulationControl referee) {
        List<RobotView> robots = moment.robots(team);
        if (robots.isEmpty()) {
            return true;
        }
        Vector3 ball = moment.ball(moment.side(team).orElseThrow());
        Vector3 torso = robots.get(0).torso();
        if (distance(ball, torso) < AT_ROBOT_METRES) {
            left = ball;
        } else if (!isMovedByReferee(moment)) {
            figures.merge(KICK_METRES, distance(ball, left), Math::max);
        }
        return isMovedByReferee(moment);
    }

    @Override
    public Map<String, Double> figures(String who) {
        return figures;
    }

    /** Once the ball is out or in the goal, the referee takes it. */
    private static boolean isMovedByReferee(JudgedMoment moment) {
        return switch (moment.world().playMode()) {
            case PLAY_ON, KICK_OFF_LEFT, KICK_OFF_RIGHT -> false;
            default -> true;
        };
    }

    private static double distance(Vector3 one, Vector3 other) {
        return Math.hypot(one.x() - other.x(), one.y() - other.y());
    }
}
