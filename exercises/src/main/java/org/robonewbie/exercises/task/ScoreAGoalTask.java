package org.robonewbie.exercises.task;

import java.util.Locale;
import org.robonewbie.exercises.Score;
import org.robonewbie.exercises.Task;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.trial.Chance;
import org.robonewbie.trial.Moment;
import org.robonewbie.trial.Place;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;

/**
 * Score a goal, alone on the pitch, as in the competition.
 */
public final class ScoreAGoalTask implements Task {

    private static final Place STUDENT = new Place(-0.5, 0.4, -40);
    private static final double GOAL_X = 6;

    /** A robot and a ball that stay where they are for so long are not going to score. */
    private static final double SECONDS_OF_PATIENCE = 30;

    private static final double STAYED_METRES = 0.1;

    private double seconds;
    private double nearest = Double.POSITIVE_INFINITY;
    private boolean scored;
    private Vector3 lastBall = Vector3.ZERO;
    private Vector3 lastTorso = Vector3.ZERO;
    private double lastMoved;

    /** Creates the task of one trial. */
    public ScoreAGoalTask() {}

    @Override
    public Scene scene(Chance chance) {
        return Scene.of(RobotStart.at(STUDENT)).withBall(0, 0);
    }

    @Override
    public void see(Moment moment) {
        Vector3 ball = moment.ball();
        nearest = Math.min(nearest, Math.hypot(GOAL_X - ball.x(), ball.y()));
        scored |= moment.goals(TeamSide.LEFT) > 0;
        seconds = moment.seconds();
        Vector3 torso = moment.robot().position();
        if (ball.distanceTo(lastBall) > STAYED_METRES || torso.distanceTo(lastTorso) > STAYED_METRES) {
            lastBall = ball;
            lastTorso = torso;
            lastMoved = seconds;
        }
    }

    @Override
    public boolean isDecided() {
        return scored || isStuck();
    }

    private boolean isStuck() {
        return seconds - lastMoved > SECONDS_OF_PATIENCE;
    }

    @Override
    public Score score() {
        if (!scored) {
            return Score.failed(
                    6 - nearest,
                    String.format(
                            Locale.ROOT,
                            "no goal%s; the ball came within %.2f m of it",
                            isStuck() ? ", and for " + Math.round(SECONDS_OF_PATIENCE) + " s nothing moved" : "",
                            nearest),
                    "Walk to where the ball is between you and the goal, then walk through the ball.");
        }
        return Score.passed(
                (int) Math.round(11 - seconds / 30), String.format(Locale.ROOT, "goal after %.1f s", seconds), "");
    }
}
