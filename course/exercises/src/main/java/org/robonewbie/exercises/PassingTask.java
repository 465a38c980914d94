package org.robonewbie.exercises;

import java.util.Locale;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/**
 * Task: pass the ball between two robots, both controlled by the student's program: number 1 kicks the ball, number 2 walks to
 * meet it.
 */
final class PassingTask implements Task {

    private static final double BALL_AHEAD = 0.187;
    private static final double BALL_LEFT = 0.063;
    private static final double MIN_METRES = 1;
    private static final double ROLLS_METRES = 0.05;
    private static final double AT_MATE_METRES = 0.45;
    private static final double CAME_METRES = 0.2;
    private static final double STAYED_METRES = 0.4;

    private Pose2d passer = new Pose2d(-2, 0, 0);
    private Pose2d mate = passer;
    private Vector3 ballStart = Vector3.ZERO;
    private double metres;
    private double nearest = Double.POSITIVE_INFINITY;
    private double came;
    private boolean dribbled;
    private boolean tooEarly;
    private boolean fallen;

    @Override
    public Scene scene(RandomSource random) {
        passer = new Pose2d(random.between(-3, -2), random.between(-1.5, 1.5), random.between(-40, 40));
        Vector3 place = passer.pointAt(random.between(2.6, 2.9), random.between(-0.7, 0.7));
        mate = new Pose2d(place.x(), place.y(), passer.degrees() + 180);
        return Scene.of(
                        RobotStart.at(passer).after("stand"),
                        RobotStart.at(mate).after("stand").withTeam(RobotStart.TEAM, 2))
                .withBall(5.5, 3.7);
    }

    @Override
    public void begin(Trial trial) {
        trial.placeBall(trial.now().place().pointAt(BALL_AHEAD, BALL_LEFT));
        ballStart = trial.ball().position();
    }

    @Override
    public void see(WorldState state) {
        metres = Math.max(metres, state.ball().distanceTo(ballStart));
        dribbled |= passer.distance(state.robot().position()) > STAYED_METRES;
        tooEarly |= metres < ROLLS_METRES && mate.distance(state.robots().get(1).position()) > STAYED_METRES;
        came = Math.max(came, mate.distance(state.robots().get(1).position()));
        if (metres >= MIN_METRES && came >= CAME_METRES) {
            nearest = Math.min(nearest, state.place(1).distance(state.ball()));
        }
        fallen |= state.robots().get(1).isFallen() || state.robot().isFallen();
    }

    @Override
    public boolean isDecided() {
        return nearest <= AT_MATE_METRES;
    }

    private String came(boolean passed) {
        if (!passed) {
            return "";
        }
        return came < CAME_METRES
                ? ", number 2 did not come to meet it"
                : String.format(Locale.ROOT, ", number 2 came within %.2f m", nearest);
    }

    @Override
    public Score score() {
        boolean passed = metres >= MIN_METRES;
        String finding = String.format(
                Locale.ROOT,
                "the ball went %.2f m%s%s%s%s",
                metres,
                came(passed),
                dribbled ? ", number 1 left its position" : "",
                tooEarly ? ", number 2 walked before the ball rolled" : "",
                fallen ? ", and a fall" : "");
        boolean fair = !dribbled && !tooEarly && !fallen;
        if (fair && nearest <= AT_MATE_METRES) {
            return Score.passed(finding);
        }
        return Score.failed(
                fair && passed ? 3 : 1,
                finding,
                "Both robots run your program: use nao.getNumber() to tell them apart. Number 1 plays \"pass-left\""
                        + " and stays where it is; number 2"
                        + " walks to the ball as soon as it rolls.");
    }
}
