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

/** A motion whose keyframes are changed: any motion of the library or of a file. */
public final class MotionParametrization implements Parametrization {

    private static final double FREE_CHANGE = 3;
    private static final double COST_OF_CHANGE = 0.05;

    private final String name;
    private final MotionFile file;
    private final KeyframeSpace space;
    private final MotionScene scene;
    private final Objective objective;

    /**
     * Creates the parametrization of a motion.
     *
     * @param name what it is called on the command line
     * @param file the motion with what its file says about it; see {@link MotionScene} for what matters
     * @param objective what is measured
     * @throws IllegalArgumentException if the motion has nothing to change or cannot be tried for this objective
     */
    public MotionParametrization(String name, MotionFile file, Objective objective) {
        this.name = name;
        this.file = file;
        this.space = new KeyframeSpace(file.motion());
        if (space.dimension() == 0) {
            throw new IllegalArgumentException(
                    file.name() + " has less than two keyframes; there is nothing to improve,"
                            + " since the last keyframe stays as it is.");
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

    /**
     * Creates a candidate.
     *
     * @param coordinates how far each number is changed
     * @return the changed motion
     */
    public Motion motion(double[] coordinates) {
        return space.motion(coordinates);
    }

    @Override
    public Evaluation evaluate(double[] coordinates, long seed) {
        Evaluation evaluation = scene.evaluate(motion(coordinates), seed);
        double far = Arrays.stream(coordinates)
                .map(x -> Math.max(0, Math.abs(x) - FREE_CHANGE))
                .sum();
        return new Evaluation(evaluation.value(), evaluation.success(), evaluation.flaws() + COST_OF_CHANGE * far);
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
        MotionFile changed = withoutOldNews().withKeyframes(motion(coordinates).keyframes());
        for (Map.Entry<String, String> fact : facts.entrySet()) {
            changed = changed.withProperty(fact.getKey(), fact.getValue());
        }
        MotionFiles.save(changed, target);
    }

    /** Leaves out facts about the original motion. */
    private MotionFile withoutOldNews() {
        String text = file.text()
                .lines()
                .filter(line -> !line.matches("//\\s*(measured|coordinates):.*"))
                .collect(Collectors.joining("\n", "", "\n"));
        return MotionFile.parse(file.name(), text);
    }
}
