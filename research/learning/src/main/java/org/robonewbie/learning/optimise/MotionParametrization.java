package org.robonewbie.learning.optimise;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.file.MotionFiles;

/** Parameters of a motion: the durations and postures of its keyframes. */
public final class MotionParametrization implements Parametrization {

    private static final double FREE_CHANGE = 3;
    private static final double CHANGE_COST = 0.05;

    private final String name;
    private final MotionFile file;
    private final KeyframeSpace space;
    private final MotionScene scene;
    private final Objective objective;

    /**
     * Creates the parametrization of a motion.
     *
     * @param name the name of the motion on the command line
     * @param file the motion and the properties in its file, from which {@link MotionScene} derives the trial
     * @param objective the objective
     * @throws IllegalArgumentException if the motion has no parameters or does not suit the objective
     */
    public MotionParametrization(String name, MotionFile file, Objective objective) {
        this.name = name;
        this.file = file;
        this.space = new KeyframeSpace(file.motion());
        if (space.dimension() == 0) {
            throw new IllegalArgumentException(file.name()
                    + " has fewer than two keyframes. There is nothing to optimise, since the last keyframe is"
                    + " fixed.");
        }
        this.scene = new MotionScene(file, objective);
        this.objective = objective;
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public int dimension() {
        return space.dimension();
    }

    @Override
    public List<Parameter> numbers(double[] coordinates) {
        return space.numbers(coordinates);
    }

    @Override
    public String fingerprint() {
        return Integer.toHexString(file.text().hashCode());
    }

    Motion motion(double[] coordinates) {
        return space.motion(coordinates);
    }

    @Override
    public Evaluation evaluate(double[] coordinates, long seed) {
        Evaluation evaluation = scene.evaluate(motion(coordinates), seed);
        double far = Arrays.stream(coordinates)
                .map(x -> Math.max(0, Math.abs(x) - FREE_CHANGE))
                .sum();
        return new Evaluation(evaluation.value(), evaluation.success(), evaluation.flaws() + CHANGE_COST * far);
    }

    @Override
    public Recipe recipe() {
        String title = file.name();
        String text = file.text();
        String label = objective.label();
        return classes ->
                new MotionParametrization(title, MotionFile.parse(title, text), Objective.named(label, classes));
    }

    @Override
    public void save(double[] coordinates, Map<String, String> facts, Path target) throws IOException {
        MotionFile changed =
                withoutMeasurements().withKeyframes(motion(coordinates).keyframes());
        for (Map.Entry<String, String> fact : facts.entrySet()) {
            changed = changed.withProperty(fact.getKey(), fact.getValue());
        }
        MotionFiles.save(changed, target);
    }

    /** Returns the file without the properties that are valid only for the original motion. */
    private MotionFile withoutMeasurements() {
        String text = file.text()
                .lines()
                .filter(line -> !line.matches("//\\s*(measured|coordinates):.*"))
                .collect(Collectors.joining("\n", "", "\n"));
        return MotionFile.parse(file.name(), text);
    }
}
