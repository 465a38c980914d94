package org.robonewbie.exercises.task;

import java.util.Locale;
import java.util.function.Supplier;
import org.robonewbie.exercises.Place;
import org.robonewbie.exercises.Program;
import org.robonewbie.exercises.Score;
import org.robonewbie.exercises.Stage;
import org.robonewbie.exercises.Task;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;

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
    public void begin(Stage stage, Supplier<? extends Program> student) {
        stage.add(student.get(), "Students", 1, STUDENT);
        stage.placeBall(Vector3.ZERO);
    }

    @Override
    public void watch(Stage stage) {
        Vector3 ball = stage.ball().position();
        nearest = Math.min(nearest, Math.hypot(GOAL_X - ball.x(), ball.y()));
        scored |= stage.game().score(TeamSide.LEFT) > 0;
        seconds = stage.seconds();
        Vector3 torso = stage.student().torso();
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
