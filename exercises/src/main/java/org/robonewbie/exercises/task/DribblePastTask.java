package org.robonewbie.exercises.task;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.robonewbie.exercises.Score;
import org.robonewbie.exercises.Task;
import org.robonewbie.nao.Vector3;
import org.robonewbie.trial.Chance;
import org.robonewbie.trial.Moment;
import org.robonewbie.trial.Place;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;

/** Bring the ball past one opponent on its left and past another one on its right, without a kick and without touching them. */
public final class DribblePastTask implements Task {

    private static final double START_X = -2.5;
    private static final double LINE_X = 2.3;
    private static final double BESIDE_METRES = 0.2;
    private static final double FAR_METRES = 1.8;
    private static final double EDGE_METRES = 2;
    private static final double PUSHED_METRES = 0.1;

    private final List<Place> opponents = new ArrayList<>();
    private double x = Double.NEGATIVE_INFINITY;
    private double farthest;
    private double aside;
    private double seconds;
    private int passed;
    private boolean wrongSide;
    private boolean pushed;

    /** Creates the task of one trial. */
    public DribblePastTask() {}

    @Override
    public Scene scene(Chance chance) {
        double y = chance.between(-0.3, 0.3);
        opponents.add(new Place(chance.between(-0.8, -0.6), chance.between(-0.2, 0.2), 180));
        opponents.add(new Place(chance.between(1.2, 1.4), chance.between(-0.2, 0.2), 180));
        return Scene.of(
                        RobotStart.at(new Place(-3.2, y, chance.between(-10, 10)))
                                .after("stand"),
                        RobotStart.at(opponents.get(0)).after("stand").withTeam("Others", 2),
                        RobotStart.at(opponents.get(1)).after("stand").withTeam("Others", 3))
                .withBall(START_X, y);
    }

    @Override
    public void see(Moment moment) {
        seconds = moment.seconds();
        Vector3 ball = moment.ball();
        if (passed < opponents.size() && ball.x() > opponents.get(passed).x()) {
            double left = ball.y() - opponents.get(passed).y();
            wrongSide |= (passed == 0 ? left : -left) < BESIDE_METRES;
            passed++;
        }
        x = ball.x();
        farthest = Math.max(farthest, moment.place().distance(ball));
        aside = Math.max(aside, Math.abs(ball.y()));
        for (int i = 0; i < opponents.size(); i++) {
            pushed |= opponents.get(i).distance(moment.robots().get(i + 1).position()) > PUSHED_METRES;
        }
    }

    @Override
    public boolean isDecided() {
        return pushed || wrongSide || farthest > FAR_METRES || aside > EDGE_METRES || x > LINE_X;
    }

    @Override
    public Score score() {
        String finding = String.format(
                Locale.ROOT,
                "brought the ball %.2f of %.2f m ahead in %.0f s, %.2f m away from it at most",
                Math.max(0, x - START_X),
                LINE_X - START_X,
                seconds,
                farthest);
        if (wrongSide) {
            return Score.failed(
                    passed - 1,
                    finding,
                    "The ball has to pass the first opponent on the left (more y) and the second one on the right (less y), each at least"
                            + " 0.2 m beside it.");
        }
        if (pushed) {
            return Score.failed(
                    1.0 + passed,
                    finding,
                    "An opponent was pushed. Choose a point beside it, 0.8 m away, and bring the ball there first; when the ball has passed"
                            + " the opponent, choose the next point.");
        }
        if (farthest > FAR_METRES) {
            return Score.failed(
                    1,
                    finding,
                    "Stay with the ball: within 1.8 m of it all the time. Dribble, do not kick, and walk more slowly.");
        }
        if (aside > EDGE_METRES) {
            return Score.failed(1, finding, "Stay within 2 m of the middle of the pitch: |y| below 2.");
        }
        return x > LINE_X
                ? Score.passed(finding)
                : Score.failed(
                        passed,
                        finding,
                        "Dribble.bring(world, target) brings the ball to a point. Which one, so that the way past the opponents is free?");
    }
}
