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
 * Walk once around the ball, without touching it and without losing it.
 */
public final class AroundTheBallTask implements Task {

    private static final Place STUDENT = new Place(-0.8, 0, 0);
    private static final double MOVED_METRES = 0.002;
    private static final double FAR_METRES = 2;

    private Vector3 ballStart = Vector3.ZERO;
    private double directionBefore;
    private double turned;
    private double moved;
    private double farthest;
    private double seconds;

    /** Creates the task of one trial. */
    public AroundTheBallTask() {}

    @Override
    public void begin(Stage stage, Supplier<? extends Program> student) {
        Program robot = student.get();
        Player player = stage.add(robot, "Students", 1, STUDENT);
        stage.placeBall(new Vector3(stage.between(-0.05, 0.3), stage.between(-0.15, 0.15), 0));
        stage.prelude(player, robot, "stand");
        ballStart = stage.ball().position();
        directionBefore = direction(stage);
    }

    @Override
    public void watch(Stage stage) {
        double direction = direction(stage);
        turned += Math.IEEEremainder(direction - directionBefore, 360);
        directionBefore = direction;
        moved = Math.max(moved, stage.ball().position().distanceTo(ballStart));
        farthest = Math.max(farthest, stage.student().distance(ballStart));
        seconds = stage.seconds();
    }

    @Override
    public boolean isDecided() {
        return Math.abs(turned) >= 360 || moved > MOVED_METRES || farthest > FAR_METRES;
    }

    @Override
    public Score score() {
        String finding = String.format(
                Locale.ROOT, "%.0f° around the ball in %.1f s, ball moved by %.3f m", Math.abs(turned), seconds, moved);
        if (moved > MOVED_METRES) {
            return Score.failed(
                    Math.abs(turned) / 60, finding, "Keep more distance: 0.5 m between torso and ball is safe.");
        }
        if (farthest > FAR_METRES) {
            return Score.failed(
                    Math.abs(turned) / 60, finding, "Stay within 2 m of the ball and keep your eyes on it.");
        }
        return Math.abs(turned) >= 360
                ? Score.passed(finding)
                : Score.failed(
                        Math.abs(turned) / 45,
                        finding,
                        "Walk sideways while you turn to the ball: walk.towards(forward, left, turn) takes all three at once.");
    }

    private static double direction(Stage stage) {
        Place here = stage.student().place();
        Vector3 ball = stage.ball().position();
        return Math.toDegrees(Math.atan2(here.y() - ball.y(), here.x() - ball.x()));
    }
}
