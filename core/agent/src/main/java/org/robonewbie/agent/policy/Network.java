package org.robonewbie.agent.policy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;

/**
 * A small neural network: {@link Layer layers} one after the other. The same numbers give the same answer on each platform.
 *
 * <pre>{@code
 * Network network = Network.of(new int[] {2, 8, 1}, numbers);
 * double answer = network.apply(0.1, -0.3)[0];
 * }</pre>
 */
public final class Network {

    private final List<Layer> layers;

    /** Joins layers of which each takes what the one before gives. */
    Network(List<Layer> layers) {
        this.layers = List.copyOf(layers);
        for (int i = 1; i < layers.size(); i++) {
            if (layers.get(i).inputs() != layers.get(i - 1).outputs()) {
                throw new IllegalArgumentException("Layer " + (i + 1) + " takes "
                        + layers.get(i).inputs() + " numbers, but the one before gives "
                        + layers.get(i - 1).outputs() + ".");
            }
        }
    }

    /**
     * Creates a network whose layers all press their sums by the hyperbolic tangent.
     *
     * @param sizes how many numbers go in and how many come out of each layer
     * @param numbers layer by layer, for each output its bias and then the weight of each input; {@link #size} of them
     * @return the network
     * @throws IllegalArgumentException if the number of numbers is wrong
     */
    public static Network of(int[] sizes, double... numbers) {
        if (numbers.length != size(sizes)) {
            throw new IllegalArgumentException("A network with layers of " + Arrays.toString(sizes) + " needs "
                    + size(sizes) + " numbers, not " + numbers.length + ".");
        }
        List<Layer> layers = new ArrayList<>();
        int from = 0;
        for (int i = 1; i < sizes.length; i++) {
            int to = from + Layer.size(sizes[i - 1], sizes[i]);
            layers.add(new Layer(sizes[i - 1], sizes[i], Layer.Activation.TANH, Arrays.copyOfRange(numbers, from, to)));
            from = to;
        }
        return new Network(layers);
    }

    /**
     * Counts the numbers of a network.
     *
     * @param sizes how many numbers go in and how many come out of each layer
     * @return how many weights and biases there are
     */
    public static int size(int... sizes) {
        int size = 0;
        for (int i = 1; i < sizes.length; i++) {
            size += Layer.size(sizes[i - 1], sizes[i]);
        }
        return size;
    }

    List<Layer> layers() {
        return layers;
    }

    /** {@return how many numbers go in} */
    public int inputs() {
        return layers.get(0).inputs();
    }

    /** {@return how many numbers come out} */
    public int outputs() {
        return layers.get(layers.size() - 1).outputs();
    }

    /** {@return the numbers of all layers, as for {@link #of}; a new array} */
    public double[] numbers() {
        return layers.stream()
                .flatMapToDouble(layer -> DoubleStream.of(layer.numbers()))
                .toArray();
    }

    /**
     * Calculates the answer.
     *
     * @param input as many numbers as the first layer takes
     * @return the last layer's outputs, each from -1 to 1
     */
    public double[] apply(double... input) {
        double[] values = input;
        for (Layer layer : layers) {
            values = layer.apply(values);
        }
        return values;
    }
}
