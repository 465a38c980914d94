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

/** The numbers that a robot's program declares by {@code number(...)}. */
public final class AgentParametrization implements Parametrization {

    private static final int DIGITS_OF_RANGE = 3;
    private static final double COST_OF_BEYOND = 0.1;

    private final String name;
    private final Supplier<Agent> maker;
    private final Objective objective;
    private final AgentScene scene;
    private final List<TunableNumber> numbers;

    /**
     * Creates the parametrization of a program.
     *
     * @param name how the program is called on the command line
     * @param maker makes a robot with the program, from any thread
     * @param objective what is measured
     * @param scene where and how long
     * @throws IllegalArgumentException if the program declares no number
     */
    public AgentParametrization(String name, Supplier<Agent> maker, Objective objective, AgentScene scene) {
        this(name, maker, objective, scene, new AgentDriver(maker.get()).numbers());
    }

    /** Creates the parametrization from known numbers, regardless of a file with numbers in this folder. */
    AgentParametrization(
            String name, Supplier<Agent> maker, Objective objective, AgentScene scene, List<TunableNumber> numbers) {
        this.name = name;
        this.maker = maker;
        this.objective = objective;
        this.scene = scene;
        this.numbers = numbers;
        if (numbers.isEmpty()) {
            throw new IllegalArgumentException(
                    name + " declares no number that could be improved. Declare one as a field of"
                            + " the class, for example: private final double stride = number(\"stride\", 5, 0, 10);");
        }
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public String words() {
        return "--agent " + name + " " + scene.words();
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
        Agent agent = TunableNumbers.with(values(coordinates), maker);
        Evaluation evaluation = scene.evaluate(agent, objective, seed);
        double beyond = IntStream.range(0, numbers.size())
                .mapToDouble(i -> beyond(i, coordinates[i]))
                .sum();
        return new Evaluation(evaluation.value(), evaluation.success(), evaluation.flaws() + COST_OF_BEYOND * beyond);
    }

    @Override
    public Recipe recipe() {
        String className = maker.get().getClass().getName();
        List<TunableNumber> known = numbers;
        AgentScene where = scene;
        String label = objective.label();
        return classes -> new AgentParametrization(
                className, () -> agent(className, classes), Objective.named(label, classes), where, known);
    }

    private static Agent agent(String className, ClassLoader classes) {
        try {
            return Class.forName(className, true, classes)
                    .asSubclass(Agent.class)
                    .getConstructor()
                    .newInstance();
        } catch (ReflectiveOperationException | ClassCastException wrong) {
            throw new IllegalArgumentException(
                    "The robot's class " + className + " cannot be created where the trials run (" + wrong
                            + "). It has to be public, with a public constructor without parameters, in a jar that goes to"
                            + " the workers.",
                    wrong);
        }
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
                        "The program takes these numbers from the file " + file() + " in the folder in which it runs."
                                + " In its text they would be:\n",
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

    /** With all coordinates 0 it is the present value; others are rounded to what can be read. */
    private double value(int index, double coordinate) {
        TunableNumber number = numbers.get(index);
        if (coordinate == 0) {
            return number.value();
        }
        double wanted = Math.max(number.least(), Math.min(number.most(), wanted(number, coordinate)));
        int places = DIGITS_OF_RANGE - (int) Math.floor(Math.log10(number.most() - number.least()));
        double rounded = BigDecimal.valueOf(wanted)
                .setScale(places, RoundingMode.HALF_EVEN)
                .doubleValue();
        return Math.max(number.least(), Math.min(number.most(), rounded));
    }

    private double beyond(int index, double coordinate) {
        TunableNumber number = numbers.get(index);
        double wanted = wanted(number, coordinate);
        return Math.max(0, Math.max(number.least() - wanted, wanted - number.most())) / size(number);
    }

    private static double wanted(TunableNumber number, double coordinate) {
        return number.value() + coordinate * size(number);
    }

    /** A quarter of the range is a change that should be noticeable. */
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
