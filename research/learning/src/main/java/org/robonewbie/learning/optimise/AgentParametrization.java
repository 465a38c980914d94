package org.robonewbie.learning.optimise;

import java.io.IOException;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.AgentDriver;
import org.robonewbie.agent.TunableNumber;
import org.robonewbie.agent.TunableNumbers;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.trial.measure.Catalogue;

/** Parameters of an agent: the numbers that its program declares with {@code number(...)}. */
public final class AgentParametrization implements Parametrization {

    private static final int DIGITS_OF_RANGE = 3;
    private static final double OUT_OF_RANGE_COST = 0.1;
    private static final Catalogue<Agent> AGENTS = new Catalogue<>("agent", Agent.class);

    private final String name;
    private final Supplier<Agent> factory;
    private final Objective objective;
    private final AgentScene scene;
    private final List<TunableNumber> numbers;

    /**
     * Creates the parametrization of an agent.
     *
     * @param name the name of the agent on the command line
     * @param factory creates an agent; must be thread-safe
     * @param objective the objective
     * @param scene the scene of the trials
     * @throws IllegalArgumentException if the agent declares no numbers
     */
    public AgentParametrization(String name, Supplier<Agent> factory, Objective objective, AgentScene scene) {
        this(name, factory, objective, scene, new AgentDriver(factory.get()).numbers());
    }

    /** Creates the parametrization with the given numbers, ignoring any file of numbers in the current folder. */
    AgentParametrization(
            String name, Supplier<Agent> factory, Objective objective, AgentScene scene, List<TunableNumber> numbers) {
        this.name = name;
        this.factory = factory;
        this.objective = objective;
        this.scene = scene;
        this.numbers = numbers;
        if (numbers.isEmpty()) {
            throw new IllegalArgumentException(name + " declares no number to optimise. Declare one as a field of"
                    + " the class, for example: private final double stride = number(\"stride\", 5, 0, 10);");
        }
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public String commandLine() {
        return "--agent " + name + " " + scene.commandLine();
    }

    @Override
    public int dimension() {
        return numbers.size();
    }

    @Override
    public List<Parameter> numbers(double[] coordinates) {
        return IntStream.range(0, numbers.size())
                .mapToObj(i -> new Parameter(numbers.get(i).name(), "", value(i, coordinates[i]), size(numbers.get(i))))
                .toList();
    }

    @Override
    public String fingerprint() {
        return Integer.toHexString((numbers + " " + scene).hashCode());
    }

    @Override
    public Evaluation evaluate(double[] coordinates, long seed) {
        Agent agent = TunableNumbers.with(values(coordinates), factory);
        Evaluation evaluation = scene.evaluate(agent, objective, seed);
        double beyond = IntStream.range(0, numbers.size())
                .mapToDouble(i -> beyond(i, coordinates[i]))
                .sum();
        return new Evaluation(
                evaluation.value(), evaluation.success(), evaluation.flaws() + OUT_OF_RANGE_COST * beyond);
    }

    @Override
    public Recipe recipe() {
        String className = factory.get().getClass().getName();
        List<TunableNumber> knownNumbers = numbers;
        AgentScene knownScene = scene;
        String label = objective.label();
        return classes -> new AgentParametrization(
                className, AGENTS.named(className, classes), Objective.named(label, classes), knownScene, knownNumbers);
    }

    @Override
    public void save(double[] coordinates, Map<String, String> facts, Path file) throws IOException {
        String comments = facts.entrySet().stream()
                .map(fact -> "# " + fact.getKey() + ": " + fact.getValue() + "\n")
                .collect(Collectors.joining());
        String lines = values(coordinates).entrySet().stream()
                .map(number -> key(number.getKey()) + " = " + number.getValue() + "\n")
                .collect(Collectors.joining());
        AtomicFile.write(file, comments + lines);
    }

    @Override
    public String advice(double[] coordinates) {
        return IntStream.range(0, numbers.size())
                .mapToObj(i -> {
                    TunableNumber number = numbers.get(i);
                    return "  number(\"" + number.name() + "\", " + value(i, coordinates[i]) + ", " + number.least()
                            + ", " + number.most() + ")";
                })
                .collect(Collectors.joining(
                        "\n",
                        "The program reads these numbers from the file " + file() + " in its working folder."
                                + " To change them in its source, write:\n",
                        "\n"));
    }

    private String file() {
        return TunableNumbers.fileName(String.valueOf(Path.of(name).getFileName())
                .replaceFirst("\\.java$", "")
                .replaceFirst("^.*\\.", ""));
    }

    private Map<String, Double> values(double[] coordinates) {
        Map<String, Double> values = new LinkedHashMap<>();
        for (int i = 0; i < numbers.size(); i++) {
            values.put(numbers.get(i).name(), value(i, coordinates[i]));
        }
        return values;
    }

    /**
     * Returns the value for a coordinate. Coordinate 0 yields the current value; any other value is clamped to the
     * range and rounded to about a thousandth of the range.
     */
    private double value(int index, double coordinate) {
        TunableNumber number = numbers.get(index);
        if (coordinate == 0) {
            return number.value();
        }
        double clamped = clamp(number, unclamped(number, coordinate));
        int places = DIGITS_OF_RANGE - (int) Math.floor(Math.log10(number.most() - number.least()));
        double rounded = BigDecimal.valueOf(clamped)
                .setScale(places, RoundingMode.HALF_EVEN)
                .doubleValue();
        return clamp(number, rounded);
    }

    /** Returns the distance of a coordinate from the range of its number; 0 if it is inside the range. */
    private double beyond(int index, double coordinate) {
        TunableNumber number = numbers.get(index);
        double value = unclamped(number, coordinate);
        return Math.abs(value - clamp(number, value)) / size(number);
    }

    private static double clamp(TunableNumber number, double value) {
        return Math.max(number.least(), Math.min(number.most(), value));
    }

    private static double unclamped(TunableNumber number, double coordinate) {
        return number.value() + coordinate * size(number);
    }

    /**
     * Returns the change of the value per unit of its coordinate: a quarter of the range, large enough to have a
     * noticeable effect.
     */
    private static double size(TunableNumber number) {
        return (number.most() - number.least()) / 4;
    }

    private static String key(String name) {
        return name.replace("\\", "\\\\")
                .replace(" ", "\\ ")
                .replace(":", "\\:")
                .replace("=", "\\=");
    }
}
