package org.robonewbie.agent.policy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;

/**
 * Text format of policies: one statement per line, words separated by spaces. Lines that begin with # are comments.
 *
 * <pre>
 * policy 1 walk
 * # learned by ./robonewbie learn walk --seed 1
 * numbers range 20
 * input tilt.pitch 10 degrees
 * output swing.KNEE_PITCH 20 degrees
 * layer 1 1 tanh
 * 0.01 -0.3
 * </pre>
 *
 * <p>A {@code layer} statement contains the numbers of inputs and outputs, and is followed by one line for each output:
 * its bias and the weights of all inputs. The activation function is {@code tanh}, {@code cut} (which clips to the range from
 * -1 to 1), {@code relu}, {@code elu}, {@code silu} or {@code linear}. That of the last layer is {@code tanh} or {@code cut}.
 */
public final class PolicyText {

    private static final String HEAD = "policy 1 ";
    private static final String REMARK = "#";
    private static final int WORDS = 3;
    private static final int MAX_LAYER_WIDTH = 1024;

    private String task = "";
    private final List<String> about = new ArrayList<>();
    private final Map<String, List<Double>> numbers = new TreeMap<>();
    private final List<Quantity> inputs = new ArrayList<>();
    private final List<Quantity> outputs = new ArrayList<>();
    private final List<Layer> layers = new ArrayList<>();
    private double[] weights = {};
    private int missing;

    private PolicyText() {}

    /**
     * Parses a policy.
     *
     * @param text the text
     * @return the policy
     * @throws IllegalArgumentException if the text is invalid; the message identifies the line
     */
    public static Policy parse(String text) {
        PolicyText reader = new PolicyText();
        String[] lines = text.split("\\R", -1);
        for (int i = 0; i < lines.length; i++) {
            try {
                reader.read(lines[i].trim(), i == 0);
            } catch (RuntimeException wrong) {
                throw new IllegalArgumentException(
                        "Line " + (i + 1) + " of the policy cannot be read: \"" + lines[i] + "\". "
                                + wrong.getMessage(),
                        wrong);
            }
        }
        return reader.policy();
    }

    private void read(String line, boolean first) {
        if (first) {
            if (!line.startsWith(HEAD)) {
                throw new IllegalArgumentException("A policy begins with \"" + HEAD + "\" and the name of its task.");
            }
            task = line.substring(HEAD.length());
        } else if (line.startsWith(REMARK)) {
            about.add(line.substring(REMARK.length()).trim());
        } else if (missing > 0 && !line.isEmpty()) {
            readRow(numbers(line.split("\\s+")));
        } else if (!line.isEmpty()) {
            readStatement(line.split("\\s+", 3));
        }
    }

    private void readStatement(String... words) {
        if (words.length < WORDS) {
            throw new IllegalArgumentException("The line is incomplete. Examples: \"input tilt.pitch 10 degrees\","
                    + " \"numbers range 20\", \"layer 1 1 tanh\".");
        }
        switch (words[0]) {
            case "numbers" ->
                numbers.put(
                        words[1],
                        Arrays.stream(numbers(words[2].split("\\s+"))).boxed().toList());
            case "input" -> inputs.add(new Quantity(words[1], words[2]));
            case "output" -> outputs.add(new Quantity(words[1], words[2]));
            case "layer" -> beginLayer(Integer.parseInt(words[1]), words[2].split("\\s+"));
            default -> throw new IllegalArgumentException("Known statements: numbers, input, output, layer.");
        }
    }

    private void beginLayer(int from, String... rest) {
        int to = Integer.parseInt(rest[0]);
        if (rest.length < 2 || from < 1 || from > MAX_LAYER_WIDTH || to < 1 || to > MAX_LAYER_WIDTH) {
            throw new IllegalArgumentException("A layer has 1 to " + MAX_LAYER_WIDTH
                    + " inputs and outputs, followed by its activation, such as \"layer 12 6 tanh\".");
        }
        layers.add(new Layer(from, to, activation(rest[1]), new double[Layer.size(from, to)]));
        weights = new double[0];
        missing = to;
    }

    private static Layer.Activation activation(String word) {
        return Arrays.stream(Layer.Activation.values())
                .filter(activation -> activation.toString().equalsIgnoreCase(word))
                .findFirst()
                .orElseThrow(
                        () -> new IllegalArgumentException("Known activations: " + Layer.Activation.names() + "."));
    }

    private void readRow(double... row) {
        Layer layer = layers.get(layers.size() - 1);
        if (row.length != layer.inputs() + 1) {
            throw new IllegalArgumentException(
                    "A bias and " + layer.inputs() + " weights are needed, not " + row.length + " numbers.");
        }
        int before = weights.length;
        weights = Arrays.copyOf(weights, before + row.length);
        System.arraycopy(row, 0, weights, before, row.length);
        missing--;
        if (missing == 0) {
            layers.set(layers.size() - 1, new Layer(layer.inputs(), layer.outputs(), layer.activation(), weights));
        }
    }

    private static double[] numbers(String... words) {
        double[] numbers = Arrays.stream(words).mapToDouble(Double::parseDouble).toArray();
        if (!Double.isFinite(Arrays.stream(numbers).sum())) {
            throw new IllegalArgumentException("All numbers must be finite.");
        }
        return numbers;
    }

    private Policy policy() {
        if (layers.isEmpty() || missing > 0) {
            throw new IllegalArgumentException("The policy \"" + task + "\" is incomplete.");
        }
        Layer.Activation last = layers.get(layers.size() - 1).activation();
        if (!last.isBounded()) {
            throw new IllegalArgumentException("The last layer of the policy \"" + task + "\" has the activation "
                    + last + ", but its outputs must lie between -1 and 1: use tanh or cut.");
        }
        return new Policy(task, about, numbers, inputs, outputs, new Network(layers));
    }

    /**
     * Formats a policy.
     *
     * @param policy the policy
     * @return text that {@link #parse} accepts, with six significant digits for each number
     */
    public static String format(Policy policy) {
        List<String> lines = new ArrayList<>();
        lines.add(HEAD + policy.task());
        policy.about().forEach(line -> lines.add(REMARK + " " + line));
        policy.numbers().forEach((name, values) -> lines.add("numbers " + name + " " + words(values)));
        policy.inputs().forEach(input -> lines.add("input " + input.name() + " " + input.unit()));
        policy.outputs().forEach(output -> lines.add("output " + output.name() + " " + output.unit()));
        for (Layer layer : policy.network().layers()) {
            lines.add("layer " + layer.inputs() + " " + layer.outputs() + " " + layer.activation());
            for (int i = 0; i < layer.outputs(); i++) {
                lines.add(words(Arrays.stream(layer.row(i)).boxed().toList()));
            }
        }
        return String.join("\n", lines) + "\n";
    }

    private static String words(List<Double> numbers) {
        return numbers.stream()
                .map(number -> number == Math.floor(number) && Math.abs(number) < 1e6
                        ? String.valueOf(number.intValue())
                        : String.format(Locale.ROOT, "%.6g", number))
                .collect(Collectors.joining(" "));
    }
}
