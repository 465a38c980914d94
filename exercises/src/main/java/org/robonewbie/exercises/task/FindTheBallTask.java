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
 * Look for a ball that lies out of sight, and face it for half a second.
 */
public final class FindTheBallTask implements Task {

    private static final Place STUDENT = new Place(-0.5, 0, 30);
    private static final double FACING_DEGREES = 10;
    private static final double HELD_SECONDS = 0.5;
    private static final double LIMIT_SECONDS = 8;
    private static final double QUICK_SECONDS = 5;

    private double facedSince = Double.NaN;
    private double foundSeconds = Double.NaN;
    private double bearing;

    /** Creates the task of one trial. */
    public FindTheBallTask() {}

    @Override
    public void begin(Stage stage, Supplier<? extends Program> student) {
        Program robot = student.get();
        Player player = stage.add(robot, "Students", 1, STUDENT);
        double side = stage.random().nextBoolean() ? 1 : -1;
        stage.placeBall(STUDENT.point(stage.between(1, 2.5), side * stage.between(100, 170), 0));
        stage.prelude(player, robot, "stand");
    }

    @Override
    public void watch(Stage stage) {
        bearing = stage.student().bearing(stage.ball().position());
        if (Math.abs(bearing) > FACING_DEGREES) {
            facedSince = Double.NaN;
        } else if (Double.isNaN(facedSince)) {
            facedSince = stage.seconds();
        } else if (stage.seconds() - facedSince >= HELD_SECONDS && Double.isNaN(foundSeconds)) {
            foundSeconds = stage.seconds();
        }
    }

    @Override
    public boolean isDecided() {
        return !Double.isNaN(foundSeconds);
    }

    @Override
    public Score score() {
        if (foundSeconds <= LIMIT_SECONDS) {
            int points = (int) Math.round(10 - 2 * Math.max(0, foundSeconds - QUICK_SECONDS));
            return Score.passed(
                    points,
                    String.format(Locale.ROOT, "faced the ball after %.1f s", foundSeconds),
                    points < 10
                            ? "The head is quicker than the legs, and the shorter way round is known once it is seen."
                            : "");
        }
        return Score.failed(
                2,
                String.format(Locale.ROOT, "the ball is still %.0f° aside", bearing),
                "Turn the head with lookAround.look() while the feet turn, and go on until the bearing is within 10°.");
    }
}
