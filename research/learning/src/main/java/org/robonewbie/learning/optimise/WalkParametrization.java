package org.robonewbie.learning.optimise;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.robonewbie.agent.walk.WalkParameter;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.learning.motion.ErraticVelocities;
import org.robonewbie.learning.motion.MotionTrial;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.trial.Measure;

/**
 * Parameters of the walk engine. A trial consists of a straight walk at full speed, which is measured, and a walk with erratic commands. A
 * trial succeeds if the robot falls in neither walk.
 */
public final class WalkParametrization implements Parametrization {

    /** Name of the walk engine on the command line. */
    public static final String NAME = "walk-engine";

    private static final double SIZE = 0.5;
    private static final double SECONDS = 7;
    private static final double ERRATIC_SECONDS = 5;
    private static final double PUSH_NEWTONS = 5;

    private final Objective objective;

    /**
     * Creates the parametrization of the walk engine.
     *
     * @param objective the objective
     */
    public WalkParametrization(Objective objective) {
        this.objective = objective;
    }

    @Override
    public String name() {
        return NAME;
    }

    @Override
    public int dimension() {
        return WalkStyle.PARAMETERS;
    }

    @Override
    public List<Parameter> numbers(double[] coordinates) {
        double[] numbers = shifted(coordinates);
        return IntStream.range(0, numbers.length)
                .mapToObj(i -> new Parameter(WalkParameter.values()[i].description(), "", numbers[i], SIZE))
                .toList();
    }

    @Override
    public String fingerprint() {
        return Integer.toHexString(Arrays.hashCode(WalkStyle.coordinates()));
    }

    @Override
    public Evaluation evaluate(double[] coordinates, long seed) {
        WalkStyle style = style(coordinates);
        boolean survives = survivesErraticWalk(style, seed);
        try (MotionTrial robot = MotionTrial.inStance(RobotType.TYPE_0, style, seed, PUSH_NEWTONS)) {
            Measure measure = objective.measure().get();
            robot.watch(measure);
            robot.walk(() -> new WalkVelocity(style.most().forward(), 0, 0), () -> robot.seconds() < SECONDS);
            double value = measure.value();
            boolean success = robot.stopWalking() && robot.endsInStance() && survives;
            double flaws = Math.abs(robot.turnedDegrees()) / 90
                    + 0.001 * robot.balance().value();
            return new Evaluation(value, success ? 1 : 0, flaws);
        }
    }

    private static boolean survivesErraticWalk(WalkStyle style, long seed) {
        try (MotionTrial robot = MotionTrial.inStance(RobotType.TYPE_0, style, seed, PUSH_NEWTONS)) {
            robot.walk(new ErraticVelocities(style, seed), () -> robot.seconds() < ERRATIC_SECONDS);
            return robot.stopWalking() && robot.endsInStance();
        }
    }

    @Override
    public Recipe recipe() {
        String label = objective.label();
        return classes -> new WalkParametrization(Objective.named(label, classes));
    }

    @Override
    public void save(double[] coordinates, Map<String, String> facts, Path file) throws IOException {
        String text = facts.entrySet().stream()
                .map(fact -> "// " + fact.getKey() + ": " + fact.getValue() + "\n")
                .collect(Collectors.joining("", "", text(shifted(coordinates)) + "\n"));
        AtomicFile.write(file, text);
    }

    private static WalkStyle style(double[] coordinates) {
        return WalkStyle.standard(shifted(coordinates));
    }

    private static double[] shifted(double[] coordinates) {
        double[] numbers = WalkStyle.coordinates();
        for (int i = 0; i < coordinates.length; i++) {
            numbers[i] = Math.round(100 * (numbers[i] + SIZE * coordinates[i])) / 100.0;
        }
        return numbers;
    }

    private static String text(double[] numbers) {
        return Arrays.stream(numbers)
                .mapToObj(x -> String.format(Locale.ROOT, "%.2f", x))
                .collect(Collectors.joining(", "));
    }
}
