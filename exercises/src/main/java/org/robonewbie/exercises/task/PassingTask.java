package org.robonewbie.exercises.task;

import java.util.Locale;
import java.util.function.Supplier;
import org.robonewbie.exercises.Place;
import org.robonewbie.exercises.Player;
import org.robonewbie.exercises.Program;
import org.robonewbie.exercises.Score;
import org.robonewbie.exercises.Stage;
import org.robonewbie.exercises.Task;
import org.robonewbie.nao.Vector3;

/**
 * Two robots of the student: number 1 plays the ball, number 2 comes to meet it.
 */
public final class PassingTask implements Task {

    private static final Place PASSER = new Place(-2, 0, 0);
    private static final double BALL_AHEAD = 0.187;
    private static final double BALL_LEFT = 0.063;
    private static final double FEWEST_METRES = 1;
    private static final double AT_MATE_METRES = 0.45;

    private Vector3 ballStart = Vector3.ZERO;
    private double metres;
    private double nearest = Double.POSITIVE_INFINITY;
    private boolean fallen;

    /** Creates the task of one trial. */
    public PassingTask() {}

    @Override
    public void begin(Stage stage, Supplier<? extends Program> student) {
        Program robot = student.get();
        Player passer = stage.add(robot, "Students", 1, PASSER);
        stage.add(student.get(), "Students", 2, new Place(0.6 + stage.between(0, 0.3), stage.between(-0.5, 0.5), 180));
        stage.placeBall(new Vector3(4, 3, 0));
        stage.prelude(passer, robot, "stand");
        Place here = passer.place();
        stage.placeBall(
                here.point(Math.hypot(BALL_AHEAD, BALL_LEFT), Math.toDegrees(Math.atan2(BALL_LEFT, BALL_AHEAD)), 0));
        ballStart = stage.ball().position();
    }

    @Override
    public void watch(Stage stage) {
        Player mate = stage.players().get(1);
        metres = Math.max(metres, stage.ball().position().distanceTo(ballStart));
        if (metres >= FEWEST_METRES) {
            nearest = Math.min(nearest, mate.distance(stage.ball().position()));
        }
        fallen |= mate.isFallen() || stage.student().isFallen();
    }

    @Override
    public boolean isDecided() {
        return nearest <= AT_MATE_METRES;
    }

    @Override
    public Score score() {
        String finding = String.format(
                Locale.ROOT,
                "the ball went %.2f m, number 2 came as near as %.2f m%s",
                metres,
                nearest,
                fallen ? ", and a fall" : "");
        return nearest <= AT_MATE_METRES && !fallen
                ? Score.passed(finding)
                : Score.failed(
                        metres >= FEWEST_METRES ? 5 : 1,
                        finding,
                        "Both robots run your program: ask nao.getNumber(). Number 1 plays \"pass-left\", number 2 walks to the"
                                + " ball as soon as it rolls.");
    }
}
