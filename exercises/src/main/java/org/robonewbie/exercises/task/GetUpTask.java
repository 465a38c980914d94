package org.robonewbie.exercises.task;

import java.util.Locale;
import java.util.function.Supplier;
import org.robonewbie.exercises.Place;
import org.robonewbie.exercises.Player;
import org.robonewbie.exercises.Program;
import org.robonewbie.exercises.Score;
import org.robonewbie.exercises.Stage;
import org.robonewbie.exercises.Task;

/**
 * Get up: the robot lies on its back with odd seeds and on its front with even ones.
 */
public final class GetUpTask implements Task {

    private static final double HELD_SECONDS = 1;
    private static final double LIMIT_SECONDS = 12;
    private static final double QUICK_SECONDS = 7;

    private double standingSince = Double.NaN;
    private double upSeconds = Double.NaN;
    private boolean onBack;

    /** Creates the task of one trial. */
    public GetUpTask() {}

    @Override
    public void begin(Stage stage, Supplier<? extends Program> student) {
        Program robot = student.get();
        Player player = stage.add(robot, "Students", 1, new Place(-1, 0, stage.between(-180, 180)));
        onBack = stage.isSeedOdd();
        stage.prelude(player, robot, "stand", onBack ? "fall-back" : "fall-forward");
    }

    @Override
    public void watch(Stage stage) {
        if (!stage.student().isStanding()) {
            standingSince = Double.NaN;
        } else if (Double.isNaN(standingSince)) {
            standingSince = stage.seconds();
        } else if (stage.seconds() - standingSince >= HELD_SECONDS) {
            upSeconds = stage.seconds();
        }
    }

    @Override
    public boolean isDecided() {
        return !Double.isNaN(upSeconds);
    }

    @Override
    public Score score() {
        String from = onBack ? "from the back" : "from the front";
        if (upSeconds <= LIMIT_SECONDS) {
            int points = (int) Math.round(10 - Math.max(0, upSeconds - QUICK_SECONDS));
            return Score.passed(points, String.format(Locale.ROOT, "stood %s after %.1f s", from, upSeconds), "");
        }
        return Score.failed(
                1,
                "did not get up " + from,
                "nao.getBodyPosition() tells how the robot lies; each way of lying needs a motion of its own.");
    }
}
