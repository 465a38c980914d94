package org.robonewbie.exercises.task;

import java.util.List;
import java.util.Locale;
import java.util.function.Supplier;
import org.robonewbie.exercises.Place;
import org.robonewbie.exercises.Player;
import org.robonewbie.exercises.Program;
import org.robonewbie.exercises.Score;
import org.robonewbie.exercises.Stage;
import org.robonewbie.exercises.Task;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;

/**
 * Stop the left shoulder at 30° ± 1°, from a place that is different each time. What was decided shows two cycles
 * later, and who forgets it goes too far.
 */
public final class StopAt30Task implements Task {

    private static final double GOAL_DEGREES = 30;
    private static final double TOLERANCE_DEGREES = 1;
    private static final double LATEST_SECONDS = 3;

    private double highest = Double.NEGATIVE_INFINITY;
    private double largestError;

    /** Creates the task of one trial. */
    public StopAt30Task() {}

    @Override
    public void begin(Stage stage, Supplier<? extends Program> student) {
        Program robot = student.get();
        Player player = stage.add(robot, "Students", 1, new Place(-1, 0, 0));
        Posture low = Posture.ZERO.with(Joint.LEFT_SHOULDER_PITCH, stage.between(-60, 0));
        stage.prelude(player, robot, new Motion("low", List.of(new Keyframe(600, low))));
    }

    @Override
    public void watch(Stage stage) {
        double degrees = stage.student().jointDegrees(Joint.LEFT_SHOULDER_PITCH);
        highest = Math.max(highest, degrees);
        if (stage.seconds() > LATEST_SECONDS) {
            largestError = Math.max(largestError, Math.abs(degrees - GOAL_DEGREES));
        }
    }

    @Override
    public Score score() {
        String finding =
                String.format(Locale.ROOT, "highest angle %.2f°, at rest %.2f° beside 30°", highest, largestError);
        boolean stopped = largestError <= TOLERANCE_DEGREES;
        boolean overshot = highest > GOAL_DEGREES + TOLERANCE_DEGREES;
        if (stopped && !overshot) {
            return Score.passed(finding);
        }
        return Score.failed(
                stopped ? 5 : 5 - largestError,
                finding,
                overshot
                        ? "When the sensor says 30, two more steps are under way: stop earlier, or get slower near the goal."
                        : "The arm must be within 1° of 30° after 3 s and stay there.");
    }
}
