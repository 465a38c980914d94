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
 * Kick a ball that lies before the left foot. Walking through it does not count.
 */
public final class KickTask implements Task {

    private static final Place STUDENT = new Place(-3, 0, 0);
    private static final double FAR_METRES = 2;
    private static final double STAYED_METRES = 0.4;
    private static final double BALL_AHEAD = 0.209;
    private static final double BALL_LEFT = 0.036;
    private static final double ERROR_METRES = 0.006;

    private Vector3 ballStart = Vector3.ZERO;
    private Vector3 robotStart = Vector3.ZERO;
    private double metres;
    private double walked;
    private boolean fallen;
    private boolean standing;

    /** Creates the task of one trial. */
    public KickTask() {}

    @Override
    public void begin(Stage stage, Supplier<? extends Program> student) {
        Program robot = student.get();
        Player player = stage.add(robot, "Students", 1, STUDENT);
        stage.placeBall(new Vector3(4, 3, 0));
        stage.prelude(player, robot, "stand");
        Place here = player.place();
        double ahead = BALL_AHEAD + stage.between(-ERROR_METRES, ERROR_METRES);
        double left = BALL_LEFT + stage.between(-ERROR_METRES, ERROR_METRES);
        stage.placeBall(here.point(Math.hypot(ahead, left), Math.toDegrees(Math.atan2(left, ahead)), 0));
        ballStart = stage.ball().position();
        robotStart = player.torso();
    }

    @Override
    public void watch(Stage stage) {
        metres = Math.max(metres, stage.ball().position().x() - ballStart.x());
        walked = Math.max(walked, stage.student().distance(robotStart));
        fallen |= stage.student().isFallen();
        standing = stage.student().isStanding();
    }

    @Override
    public Score score() {
        String finding = String.format(
                Locale.ROOT,
                "the ball went %.2f m, the robot moved %.2f m%s",
                metres,
                walked,
                fallen ? " and fell" : "");
        if (fallen || !standing) {
            return Score.failed(2 * metres, finding, "Shift the weight onto the other foot before the leg swings.");
        }
        if (walked > STAYED_METRES) {
            return Score.failed(2, finding, "Kick from where you stand: that was a walk.");
        }
        return metres >= FAR_METRES
                ? Score.passed(
                        (int) Math.round(7 + metres - FAR_METRES), finding, metres < 5 ? "10 points are for 5 m." : "")
                : Score.failed(
                        4 * metres, finding, "The foot must be quick where the ball lies: a short keyframe there.");
    }
}
