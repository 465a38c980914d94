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
 * Walk as far as possible in 10 seconds.
 */
public final class FasterWalkTask implements Task {

    private static final Place STUDENT = new Place(-5, 0, 0);
    private static final double FAR_METRES = 4;
    private static final double ASIDE_METRES = 1;

    private double metres;
    private double aside;
    private boolean fallen;

    /** Creates the task of one trial. */
    public FasterWalkTask() {}

    @Override
    public void begin(Stage stage, Supplier<? extends Program> student) {
        Program robot = student.get();
        Player player = stage.add(robot, "Students", 1, STUDENT);
        stage.placeBall(new Vector3(4, 3.5, 0));
        stage.prelude(player, robot, "stand");
    }

    @Override
    public void watch(Stage stage) {
        metres = stage.student().torso().x() - STUDENT.x();
        aside = Math.max(aside, Math.abs(stage.student().torso().y()));
        fallen |= stage.student().isFallen();
    }

    @Override
    public boolean isDecided() {
        return fallen;
    }

    @Override
    public Score score() {
        String finding = String.format(
                Locale.ROOT, "%.2f m in 10 s, at most %.2f m aside%s", metres, aside, fallen ? ", then a fall" : "");
        if (fallen) {
            return Score.failed(
                    metres, finding, "Too fast: change one parameter at a time and try each several times.");
        }
        return metres >= FAR_METRES && aside <= ASIDE_METRES
                ? Score.passed((int) Math.round(7 + 2 * (metres - FAR_METRES)), finding, "")
                : Score.failed(
                        2 * metres,
                        finding,
                        "Let a program try many values, keep the best, and vary it again; the points are what it climbs.");
    }
}
