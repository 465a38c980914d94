package org.robonewbie.learning.optimise;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;

/** A subject without robot: its value is the height of a hill, seen through some noise. */
final class Hill implements Parametrization {

    private static final double HEIGHT = 10;
    private static final double NOISE = 0.01;

    private final double away;

    Hill() {
        this(1);
    }

    /** Begins that far from the top in each direction. */
    Hill(double away) {
        this.away = away;
    }

    @Override
    public String name() {
        return "hill";
    }

    @Override
    public int dimension() {
        return 4;
    }

    @Override
    public List<Parameter> numbers(double[] coordinates) {
        return Arrays.stream(coordinates)
                .mapToObj(x -> new Parameter("way", "m", x, 1))
                .toList();
    }

    @Override
    public String fingerprint() {
        return Double.toString(away);
    }

    @Override
    public Evaluation evaluate(double[] coordinates, long seed) {
        double below =
                Arrays.stream(coordinates).map(x -> (x - away) * (x - away)).sum();
        double noise = NOISE * new Random(seed).nextGaussian();
        return new Evaluation(HEIGHT - below + noise, 1, 0);
    }

    @Override
    public void save(double[] coordinates, Map<String, String> facts, Path file) throws IOException {
        Files.writeString(
                file,
                Arrays.toString(coordinates) + "\n"
                        + String.join(
                                "\n",
                                facts.entrySet().stream()
                                        .map(fact -> fact.getKey() + ": " + fact.getValue())
                                        .toList()));
    }
}
