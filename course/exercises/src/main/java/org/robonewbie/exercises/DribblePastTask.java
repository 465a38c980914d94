package org.robonewbie.exercises;

import java.util.Locale;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.WorldState;

/**
 * Task: dribble past the left side of an opponent without touching the opponent or kicking the ball. The direct path leads
 * past the opponent's right side.
 */
final class DribblePastTask implements Task {

    private static final double START_X = -2.5;
    private static final double LINE_X = 0.9;
    private static final double BESIDE_METRES = 0.2;
    private static final double FAR_METRES = 1.8;
    private static final double EDGE_METRES = 3;
    private static final double PUSHED_METRES = 0.1;

    private Pose2d opponent = new Pose2d(0, 0, 180);
    private double x = Double.NEGATIVE_INFINITY;
    private double farthest;
    private double aside;
    private double seconds;
    private boolean passed;
    private boolean wrongSide;
    private boolean pushed;

    @Override
    public Scene scene(RandomSource random) {
        double y = random.between(0, 0.3);
        opponent = new Pose2d(random.between(-0.5, -0.3), y + random.between(0.15, 0.3), 180);
        return Scene.of(
                        RobotStart.at(new Pose2d(-3.2, y, random.between(-10, 10)))
                                .after("stand"),
                        RobotStart.at(opponent).after("stand").withTeam("Others", 2))
                .withBall(START_X, y);
    }

    @Override
    public void see(WorldState state) {
        seconds = state.seconds();
        Vector3 ball = state.ball();
        if (!passed && ball.x() > opponent.x()) {
            passed = true;
            wrongSide = ball.y() - opponent.y() < BESIDE_METRES;
        }
        x = ball.x();
        farthest = Math.max(farthest, state.place().distance(ball));
        aside = Math.max(aside, Math.abs(ball.y()));
        pushed |= opponent.distance(state.robots().get(1).position()) > PUSHED_METRES;
    }

    @Override
    public boolean isDecided() {
        return pushed || wrongSide || farthest > FAR_METRES || aside > EDGE_METRES || x > LINE_X;
    }

    @Override
    public Score score() {
        String finding = String.format(
                Locale.ROOT,
                "moved the ball %.2f of %.2f m forward in %.0f s, never more than %.2f m from it",
                Math.max(0, x - START_X),
                LINE_X - START_X,
                seconds,
                farthest);
        if (wrongSide) {
            return Score.failed(
                    2,
                    finding,
                    "The ball must pass the opponent on its left (greater y), at least 0.2 m away from it.");
        }
        if (pushed) {
            return Score.failed(
                    passed ? 3 : 2,
                    finding,
                    "The opponent was pushed. Choose a point 0.8 m to its left, and take the ball"
                            + " there first; once the ball has passed the opponent, continue to the goal.");
        }
        if (farthest > FAR_METRES) {
            return Score.failed(
                    1,
                    finding,
                    "Stay within 1.8 m of the ball at all times. Dribble instead of kicking, and walk more slowly.");
        }
        if (aside > EDGE_METRES) {
            return Score.failed(1, finding, "Stay within 3 m of the middle of the pitch: |y| below 3.");
        }
        return x > LINE_X
                ? Score.passed(finding)
                : Score.failed(
                        passed ? 3 : 0,
                        finding,
                        "Dribble.bring(world, target) brings the ball to a point. Which point leaves the way past the"
                                + " opponent clear?");
    }
}
