package org.robonewbie.agent.policy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
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
 *
 * <p>Other kinds of layers are named after the activation. {@code layer 64 64 elu layer-norm 1e-05} is a layer normalisation with
 * the given epsilon; each of its lines contains a bias and a factor. {@code layer 12 64 linear gru} is a gated recurrent unit with
 * three lines for each output: first those of all reset gates, then those of all update gates, then those of all candidates. Each
 * line contains the bias of the inputs, the bias of the last outputs, the weights of all inputs and those of all last outputs.
 *
 * <p>A layer may be packed: {@code layer 64 64 elu packed 40} is followed by 40 lines of text in base 85 (RFC 1924), which together
 * contain a zlib stream of these bytes, in little-endian order:
 *
 * <ol>
 *   <li>for each column of weights, a signed byte <i>e</i>
 *   <li>for each row, its biases and a step <i>s</i>, as float32
 *   <li>for each weight, row by row, the lowest byte of an integer; then all middle bytes, then all highest bytes. The lowest bit of
 *       the integer is its sign (zigzag encoding).
 * </ol>
 *
 * <p>The weight is <i>s</i> · 2<sup><i>e</i></sup> times the signed integer.
 */
public final class PolicyText {

    private static final String HEAD = "policy 1 ";
    private static final String REMARK = "#";
    private static final int WORDS = 3;
    private static final int MAX_LAYER_WIDTH = 1024;
    private static final int MAX_NUMBERS = 4_000_000;
    private static final int MAX_SHOWN = 60;
    private static final String PACKED = "packed";

    private String task = "";
    private final List<String> about = new ArrayList<>();
    private final Map<String, List<Double>> numbers = new TreeMap<>();
    private final List<Quantity> inputs = new ArrayList<>();
    private final List<Quantity> outputs = new ArrayList<>();
    private final List<Layer> layers = new ArrayList<>();
    private int total;
    private Header header = new Header(0, 0, Activation.LINEAR, Optional.empty(), false);
    private double[] weights = {};
    private int filled;
    private int missing;
    private final StringBuilder packed = new StringBuilder();
    private int missingPacked;

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
                        "Line " + (i + 1) + " of the policy cannot be read: \"" + shortened(lines[i]) + "\". "
                                + wrong.getMessage(),
                        wrong);
            }
        }
        return reader.policy();
    }

    private static String shortened(String line) {
        return line.length() <= MAX_SHOWN ? line : line.substring(0, MAX_SHOWN) + "…";
    }

    private void read(String line, boolean first) {
        if (first) {
            if (!line.startsWith(HEAD)) {
                throw new IllegalArgumentException("A policy begins with \"" + HEAD + "\" and the name of its task.");
            }
            task = line.substring(HEAD.length());
        } else if (missingPacked > 0) {
            readPacked(line);
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
            case "layer" -> beginLayer(integer(words[1]), words[2].split("\\s+"));
            default -> throw new IllegalArgumentException("Known statements: numbers, input, output, layer.");
        }
    }

    private void beginLayer(int from, String... rest) {
        int to = integer(rest[0]);
        if (rest.length < 2 || from < 1 || from > MAX_LAYER_WIDTH || to < 1 || to > MAX_LAYER_WIDTH) {
            throw new IllegalArgumentException("A layer has 1 to " + MAX_LAYER_WIDTH
                    + " inputs and outputs, followed by its activation, such as \"layer 12 6 tanh\".");
        }
        List<String> kind = new ArrayList<>(List.of(rest).subList(2, rest.length));
        int lines =
                kind.size() > 1 && kind.get(kind.size() - 2).equals(PACKED) ? integer(kind.get(kind.size() - 1)) : 0;
        if (lines > 0) {
            kind.subList(kind.size() - 2, kind.size()).clear();
        }
        header = Header.of(from, to, Activation.named(rest[1]), kind);
        Layer.Table table = header.table();
        if (table.size() > MAX_NUMBERS - total) {
            throw new IllegalArgumentException(
                    "The policy would have more than " + MAX_NUMBERS + " weights. Use fewer or smaller layers.");
        }
        total += table.size();
        missingPacked = lines;
        packed.setLength(0);
        missing = lines > 0 ? 0 : table.rows();
        weights = lines > 0 ? new double[0] : new double[table.size()];
        filled = 0;
    }

    /**
     * First line of a layer.
     *
     * @param inputs number of inputs
     * @param outputs number of outputs
     * @param activation activation function
     * @param epsilon epsilon of a layer normalisation
     * @param recurrent whether the layer is a gated recurrent unit
     */
    private record Header(int inputs, int outputs, Activation activation, Optional<Double> epsilon, boolean recurrent) {

        static Header of(int inputs, int outputs, Activation activation, List<String> kind) {
            if (kind.isEmpty()) {
                return new Header(inputs, outputs, activation, Optional.empty(), false);
            }
            if (kind.equals(List.of(GruLayer.NAME))) {
                return new Header(inputs, outputs, activation, Optional.empty(), true);
            }
            if (kind.size() == 2 && kind.get(0).equals(LayerNormalization.NAME) && inputs == outputs) {
                double epsilon = numbers(kind.get(1))[0];
                if (epsilon > 0) {
                    return new Header(inputs, outputs, activation, Optional.of(epsilon), false);
                }
            }
            throw new IllegalArgumentException("\"" + String.join(" ", kind)
                    + "\" is unknown. After the activation may stand \"gru\" or, if there are as many inputs as outputs,"
                    + " \"layer-norm 1e-05\" with a positive epsilon; then \"packed\" and a number of lines.");
        }

        Layer.Table table() {
            if (recurrent) {
                return GruLayer.table(inputs, outputs);
            }
            return epsilon.isPresent() ? LayerNormalization.table(outputs) : DenseLayer.table(inputs, outputs);
        }

        Layer layer(double... numbers) {
            if (recurrent) {
                return new GruLayer(inputs, outputs, activation, numbers);
            }
            return epsilon.isPresent()
                    ? new LayerNormalization(outputs, epsilon.get(), activation, numbers)
                    : new DenseLayer(inputs, outputs, activation, numbers);
        }
    }

    private void readRow(double... row) {
        Layer.Table table = header.table();
        if (row.length != table.columns()) {
            String biases = table.biases() == 1 ? "A bias and " : "2 biases and ";
            throw new IllegalArgumentException(
                    (header.epsilon().isPresent() ? "A bias and a factor" : biases + table.weights() + " weights")
                            + " are needed, not " + row.length + " numbers.");
        }
        System.arraycopy(row, 0, weights, filled, row.length);
        filled += row.length;
        missing--;
        if (missing == 0) {
            layers.add(header.layer(weights));
        }
    }

    private void readPacked(String line) {
        packed.append(line);
        missingPacked--;
        if (missingPacked == 0) {
            try {
                weights = PackedWeights.unpack(packed, header.table());
            } catch (IllegalArgumentException damaged) {
                throw new IllegalArgumentException(
                        damaged.getMessage() + " Write the policy again, and copy the file as a whole.", damaged);
            }
            requireFinite(weights);
            layers.add(header.layer(weights));
        }
    }

    private static int integer(String word) {
        try {
            return Integer.parseInt(word);
        } catch (NumberFormatException wrong) {
            throw new IllegalArgumentException("\"" + shortened(word) + "\" is not a whole number.", wrong);
        }
    }

    private static double number(String word) {
        try {
            return Double.parseDouble(word);
        } catch (NumberFormatException wrong) {
            throw new IllegalArgumentException(
                    "\"" + shortened(word) + "\" is not a number. Write numbers such as -0.25 or 1e-3.", wrong);
        }
    }

    private static double[] numbers(String... words) {
        double[] numbers = Arrays.stream(words).mapToDouble(PolicyText::number).toArray();
        requireFinite(numbers);
        return numbers;
    }

    private static void requireFinite(double... numbers) {
        if (!Double.isFinite(Arrays.stream(numbers).sum())) {
            throw new IllegalArgumentException("All numbers must be finite.");
        }
    }

    private Policy policy() {
        if (layers.isEmpty() || missing > 0 || missingPacked > 0) {
            throw new IllegalArgumentException("The policy \"" + task + "\" is incomplete.");
        }
        Activation last = layers.get(layers.size() - 1).activation();
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
     * @return text that {@link #parse} accepts, with the same numbers
     */
    public static String format(Policy policy) {
        List<String> lines = new ArrayList<>();
        lines.add(HEAD + policy.task());
        policy.about().forEach(line -> lines.add(REMARK + " " + line));
        policy.numbers().forEach((name, values) -> lines.add("numbers " + name + " " + words(values)));
        policy.inputs().forEach(input -> lines.add("input " + input.name() + " " + input.unit()));
        policy.outputs().forEach(output -> lines.add("output " + output.name() + " " + output.unit()));
        for (Layer layer : policy.network().layers()) {
            lines.add("layer " + layer.inputs() + " " + layer.outputs() + " " + layer.activation()
                    + (layer.kind().isEmpty() ? "" : " " + layer.kind()));
            for (int i = 0; i < layer.table().rows(); i++) {
                lines.add(words(Arrays.stream(layer.row(i)).boxed().toList()));
            }
        }
        return String.join("\n", lines) + "\n";
    }

    private static String words(List<Double> numbers) {
        return numbers.stream()
                .map(number -> number == Math.floor(number) && Math.abs(number) < 1e6
                        ? String.valueOf(number.intValue())
                        : String.valueOf(number))
                .collect(Collectors.joining(" "));
    }
}
