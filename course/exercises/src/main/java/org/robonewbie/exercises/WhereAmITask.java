package org.robonewbie.exercises;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/** Task: report the position of the robot on the pitch; the robot is moved halfway through the trial. */
final class WhereAmITask implements Task {

    private static final Pattern WORDS = Pattern.compile("at:(-?\\d+(?:\\.\\d+)?):(-?\\d+(?:\\.\\d+)?)");
    private static final double CARRIED_SECONDS = 12;
    private static final double THINKING_SECONDS = 10;
    private static final double GOOD_METRES = 0.3;

    private final List<Double> errors = new ArrayList<>();
    private RandomSource places = new RandomSource(0);
    private Optional<String> words = Optional.empty();
    private boolean carried;
    private double said = Double.POSITIVE_INFINITY;

    @Override
    public Scene scene(RandomSource random) {
        places = random;
        return Scene.of(RobotStart.at(somewhere()));
    }

    @Override
    public void act(Trial trial) {
        if (!carried && trial.seconds() >= CARRIED_SECONDS) {
            carried = true;
            errors.add(said);
            said = Double.POSITIVE_INFINITY;
            trial.moveRobot(0, somewhere());
        }
        words = trial.said(0);
    }

    @Override
    public void see(WorldState state) {
        double sinceMoved = state.seconds() - (carried ? CARRIED_SECONDS : 0);
        words.map(WORDS::matcher).filter(Matcher::matches).ifPresent(match -> {
            double x = Double.parseDouble(match.group(1));
            double y = Double.parseDouble(match.group(2));
            if (sinceMoved > THINKING_SECONDS) {
                said = state.place().distance(new Vector3(x, y, 0));
            }
        });
    }

    @Override
    public Score score() {
        List<Double> all = new ArrayList<>(errors);
        all.add(said);
        double worst = all.stream().mapToDouble(Double::doubleValue).max().orElse(said);
        String finding = "first position " + describe(all.get(0))
                + (all.size() > 1 ? ", second position " + describe(all.get(1)) : "");
        if (Double.isInfinite(worst)) {
            return Score.failed(
                    0,
                    finding,
                    "From 10 s on, report your position in every cycle, for example with"
                            + " nao.say(\"at:-2.31:1.05\").");
        }
        return worst <= GOOD_METRES
                ? Score.passed(finding)
                : Score.failed(
                        3 - worst,
                        finding,
                        "Two landmarks with distance and bearing give your position;"
                                + " SoccerField.BEGINNER.position(landmark) returns the position of a landmark."
                                + " Discard what was seen before the robot was moved.");
    }

    private static String describe(double error) {
        return Double.isInfinite(error) ? "not said" : String.format(Locale.ROOT, "%.2f m off", error);
    }

    private Pose2d somewhere() {
        return new Pose2d(places.between(-4.5, 3), places.between(-2.5, 2.5), places.between(-180, 180));
    }
}
