package org.robonewbie.agent.policy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;

/**
 * Small neural network. It is immutable; the state of recurrent layers is in an {@link InferenceSession}. Equal parameters and inputs
 * yield equal outputs on every platform.
 *
 * <pre>{@code
 * Network network = Network.of(new int[] {2, 8, 1}, numbers);
 * double answer = network.apply(0.1, -0.3)[0];
 * }</pre>
 */
public final class Network {

    private final List<Layer> layers;

    /** Connects layers; each layer must have as many inputs as the previous one has outputs. */
    Network(List<Layer> layers) {
        this.layers = List.copyOf(layers);
        for (int i = 1; i < layers.size(); i++) {
            if (layers.get(i).inputs() != layers.get(i - 1).outputs()) {
                throw new IllegalArgumentException("Layer " + (i + 1) + " has "
                        + layers.get(i).inputs() + " inputs, but the previous layer has "
                        + layers.get(i - 1).outputs() + " outputs.");
            }
        }
    }

    /**
     * Creates a network with the activation function tanh in all layers.
     *
     * @param sizes number of inputs, then number of outputs of each layer
     * @param numbers parameters, layer by layer: for each output, its bias and then the weight of each input; {@link
     *     #size} values
     * @return the network
     * @throws IllegalArgumentException if there are too few or too many parameters
     */
    public static Network of(int[] sizes, double... numbers) {
        if (numbers.length != size(sizes)) {
            throw new IllegalArgumentException("A network with layers of " + Arrays.toString(sizes) + " needs "
                    + size(sizes) + " numbers, not " + numbers.length + ".");
        }
        List<Layer> layers = new ArrayList<>();
        int from = 0;
        for (int i = 1; i < sizes.length; i++) {
            int to = from + DenseLayer.table(sizes[i - 1], sizes[i]).size();
            layers.add(new DenseLayer(sizes[i - 1], sizes[i], Activation.TANH, Arrays.copyOfRange(numbers, from, to)));
            from = to;
        }
        return new Network(layers);
    }

    /**
     * Counts the parameters of a network.
     *
     * @param sizes number of inputs, then number of outputs of each layer
     * @return number of weights and biases
     */
    public static int size(int... sizes) {
        int size = 0;
        for (int i = 1; i < sizes.length; i++) {
            size += DenseLayer.table(sizes[i - 1], sizes[i]).size();
        }
        return size;
    }

    List<Layer> layers() {
        return layers;
    }

    /** {@return the number of inputs} */
    public int inputs() {
        return layers.get(0).inputs();
    }

    /** {@return the number of outputs} */
    public int outputs() {
        return layers.get(layers.size() - 1).outputs();
    }

    /** {@return the parameters of all layers in the order of {@link #of}, as a new array} */
    public double[] numbers() {
        return layers.stream()
                .flatMapToDouble(layer -> DoubleStream.of(layer.numbers()))
                .toArray();
    }

    /**
     * Evaluates the network. Recurrent layers remember nothing; use a {@link #session} to evaluate them step by step.
     *
     * @param input values of the inputs
     * @return the outputs, each from -1 to 1
     */
    public double[] apply(double... input) {
        return session().apply(input);
    }

    /** {@return a new session, which remembers nothing yet} */
    public InferenceSession session() {
        return new InferenceSession(layers);
    }
}
