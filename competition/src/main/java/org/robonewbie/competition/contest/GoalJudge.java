package org.robonewbie.competition.contest;

import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.SimulationControl;

/**
 * Waits for one team's goal, and measures how near the ball comes to it: the centre of the ball to the nearest point between the
 * opponents' goal posts on the goal line. Own goals do not count.
 */
final class GoalJudge implements Judge {

    static final String GOAL_SECONDS = "goalSeconds";
    static final String BALL_METRES = "ballMetres";

    private final String team;
    private final SoccerField field;
    private final Map<String, Double> figures = new TreeMap<>();

    GoalJudge(ContestTrial trial, String team) {
        this.team = team;
        this.field = trial.parameters().field();
    }

    @Override
    public boolean watch(JudgedMoment moment, SimulationControl referee) {
        Optional<TeamSide> side = moment.side(team);
        if (side.isEmpty()) {
            return true;
        }
        boolean goal = moment.goals(side.get()) > 0;
        if (goal) {
            figures.put(GOAL_SECONDS, moment.seconds());
        }
        figures.merge(BALL_METRES, goal ? 0 : distance(moment.ball(side.get())), Math::min);
        return goal;
    }

    @Override
    public Map<String, Double> figures(String who) {
        return who.equals(team) ? figures : Map.of();
    }

    private double distance(Vector3 ball) {
        double ahead = Math.max(0, field.length() / 2 - ball.x());
        double aside = Math.max(0, Math.abs(ball.y()) - field.goalWidth() / 2);
        return Math.hypot(ahead, aside);
    }
}
