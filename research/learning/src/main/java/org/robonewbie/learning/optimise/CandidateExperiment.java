package org.robonewbie.learning.optimise;

import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.robonewbie.learning.series.Experiment;

/**
 * Trials of candidates as an experiment, which another computer can carry out: the texts of a trial say what is tried
 * ({@link SubjectRecipe}), its numbers are the coordinates.
 */
public final class CandidateExperiment implements Experiment {

    /** Creates the experiment. */
    public CandidateExperiment() {}

    /** Returns the name of a coordinate among the numbers of a trial. */
    static String coordinate(int index) {
        return "x" + index;
    }

    @Override
    public List<String> columns() {
        return List.of("value", "success", "flaws");
    }

    @Override
    public double[] run(Map<String, Double> numbers, long seed) {
        throw new IllegalArgumentException("A trial of a candidate needs texts that say what is tried.");
    }

    @Override
    public double[] run(Map<String, Double> numbers, Map<String, String> texts, long seed) {
        double[] coordinates = IntStream.range(0, numbers.size())
                .mapToDouble(i -> numbers.getOrDefault(coordinate(i), 0.0))
                .toArray();
        Evaluation evaluation = SubjectRecipe.subject(texts).evaluate(coordinates, seed);
        return new double[] {evaluation.value(), evaluation.success(), evaluation.flaws()};
    }
}
