package org.robonewbie.exercises.task;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robonewbie.exercises.Place;
import org.robonewbie.exercises.Player;
import org.robonewbie.exercises.Program;
import org.robonewbie.exercises.Score;
import org.robonewbie.exercises.Stage;
import org.robonewbie.exercises.Task;
import org.robonewbie.nao.Vector3;

/**
 * Find out where on the pitch the robot stands; in the middle of the trial it is carried to another place.
 */
public final class WhereAmITask implements Task {

    private static final Pattern WORDS = Pattern.compile("at:(-?\\d+(?:\\.\\d+)?):(-?\\d+(?:\\.\\d+)?)");
    private static final double CARRIED_SECONDS = 12;
    private static final double THINKING_SECONDS = 10;
    private static final double GOOD_METRES = 0.3;

    private final List<Double> errors = new ArrayList<>();
    private boolean carried;
    private double said = Double.POSITIVE_INFINITY;

    /** Creates the task of one trial. */
    public WhereAmITask() {}

    @Override
    public void begin(Stage stage, Supplier<? extends Program> student) {
        stage.add(student.get(), "Students", 1, somewhere(stage));
    }

    @Override
    public void watch(Stage stage) {
        Player robot = stage.student();
        if (!carried && stage.seconds() >= CARRIED_SECONDS) {
            carried = true;
            errors.add(said);
            said = Double.POSITIVE_INFINITY;
            robot.moveTo(somewhere(stage));
        }
        double sinceMoved = stage.seconds() - (carried ? CARRIED_SECONDS : 0);
        robot.said().map(WORDS::matcher).filter(Matcher::matches).ifPresent(match -> {
            double x = Double.parseDouble(match.group(1));
            double y = Double.parseDouble(match.group(2));
            if (sinceMoved > THINKING_SECONDS) {
                said = robot.distance(new Vector3(x, y, 0));
            }
        });
    }

    @Override
    public Score score() {
        errors.add(said);
        double worst = errors.stream().mapToDouble(Double::doubleValue).max().orElse(said);
        String finding = String.format(
                Locale.ROOT,
                "errors of the two places: %.2f m and %.2f m",
                errors.get(0),
                errors.get(errors.size() - 1));
        if (Double.isInfinite(worst)) {
            return Score.failed(
                    0, finding, "From 10 s on say in each cycle where you are, such as nao.say(\"at:-2.31:1.05\").");
        }
        return worst <= GOOD_METRES
                ? Score.passed(finding)
                : Score.failed(
                        5 - worst,
                        finding,
                        "Two landmarks with distance and bearing give the place; SoccerField.BEGINNER.position(landmark) tells"
                                + " where they stand. Forget what was seen before the robot was carried away.");
    }

    private static Place somewhere(Stage stage) {
        return new Place(stage.between(-4.5, 3), stage.between(-2.5, 2.5), stage.between(-180, 180));
    }
}
