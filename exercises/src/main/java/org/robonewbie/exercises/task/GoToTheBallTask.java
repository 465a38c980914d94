package org.robonewbie.exercises.task;

import java.util.Locale;
import java.util.function.Supplier;
import org.robonewbie.exercises.Place;
import org.robonewbie.exercises.Player;
import org.robonewbie.exercises.Program;
import org.robonewbie.exercises.Score;
import org.robonewbie.exercises.Stage;
import org.robonewbie.exercises.Task;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;

/**
 * Three things one after the other: walk to the ball, stop before it, raise the arm. The ball must not be touched.
 */
public final class GoToTheBallTask implements Task {

    private static final double NEAR_METRES = 0.5;
    private static final double FACING_DEGREES = 20;
    private static final double MOVED_METRES = 0.02;
    private static final double UP_DEGREES = 60;
    private static final double HELD_SECONDS = 1;

    private Vector3 ballStart = Vector3.ZERO;
    private double nearest = Double.POSITIVE_INFINITY;
    private double moved;
    private boolean fallen;
    private double heldSince = Double.NaN;
    private double doneSeconds = Double.NaN;

    /** Creates the task of one trial. */
    public GoToTheBallTask() {}

    @Override
    public void begin(Stage stage, Supplier<? extends Program> student) {
        Program robot = student.get();
        Place start = new Place(-2.5, stage.between(-1, 1), stage.between(-60, 60));
        Player player = stage.add(robot, "Students", 1, start);
        stage.placeBall(start.point(stage.between(1.5, 2.5), stage.between(-50, 50), 0));
        stage.prelude(player, robot, "stand");
        ballStart = stage.ball().position();
    }

    @Override
    public void watch(Stage stage) {
        Player robot = stage.student();
        moved = Math.max(moved, stage.ball().position().distanceTo(ballStart));
        fallen |= robot.isFallen();
        double distance = robot.distance(stage.ball().position());
        nearest = Math.min(nearest, distance);
        boolean done = distance <= NEAR_METRES
                && Math.abs(robot.bearing(stage.ball().position())) <= FACING_DEGREES
                && robot.jointDegrees(Joint.LEFT_SHOULDER_PITCH) >= UP_DEGREES;
        if (!done) {
            heldSince = Double.NaN;
        } else if (Double.isNaN(heldSince)) {
            heldSince = stage.seconds();
        } else if (stage.seconds() - heldSince >= HELD_SECONDS) {
            doneSeconds = stage.seconds();
        }
    }

    @Override
    public boolean isDecided() {
        return !Double.isNaN(doneSeconds) || moved > MOVED_METRES;
    }

    @Override
    public Score score() {
        String finding = String.format(
                Locale.ROOT, "nearest %.2f m, ball moved by %.3f m%s", nearest, moved, fallen ? ", and a fall" : "");
        if (moved > MOVED_METRES) {
            return Score.failed(
                    3, finding, "The feet reach further than the torso: stop at 0.4 m, and get slower before.");
        }
        if (Double.isNaN(doneSeconds)) {
            return Score.failed(
                    nearest <= NEAR_METRES ? 5 : 1,
                    finding,
                    "Within 0.5 m of the ball and facing it, the left shoulder must be above 60° for 1 s.");
        }
        return Score.passed(String.format(Locale.ROOT, "%s, done after %.1f s", finding, doneSeconds));
    }
}
