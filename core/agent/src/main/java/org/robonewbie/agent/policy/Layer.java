package org.robonewbie.agent.policy;

import java.util.Arrays;
import org.robonewbie.nao.math.PortableMath;

/**
 * Fully connected layer of a neural network: each output is the activation of a weighted sum of all inputs and a bias.
 *
 * @param inputs number of inputs
 * @param outputs number of outputs
 * @param activation applied to each sum
 * @param numbers parameters: for each output, its bias and then the weight of each input
 */
@SuppressWarnings("ArrayRecordComponent")
record Layer(int inputs, int outputs, Activation activation, double[] numbers) {

    /** Activation function; its values lie between -1 and 1. */
    enum Activation {
        /** Hyperbolic tangent. */
        TANH {
            @Override
            double of(double sum) {
                return 1 - 2 / (PortableMath.exp(2 * sum) + 1);
            }
        },
        /** Clipping to the range from -1 to 1. */
        CUT {
            @Override
            double of(double sum) {
                return Math.max(-1, Math.min(1, sum));
            }
        };

        abstract double of(double sum);
    }

    Layer {
        numbers = numbers.clone();
        if (numbers.length != size(inputs, outputs)) {
            throw new IllegalArgumentException("A layer with " + inputs + " inputs and " + outputs + " outputs needs "
                    + size(inputs, outputs) + " numbers, not " + numbers.length + ".");
        }
    }

    static int size(int inputs, int outputs) {
        return outputs * (inputs + 1);
    }

    double[] apply(double... input) {
        double[] output = new double[outputs];
        for (int i = 0; i < outputs; i++) {
            int first = i * (inputs + 1);
            double sum = numbers[first];
            for (int j = 0; j < inputs; j++) {
                sum += numbers[first + 1 + j] * input[j];
            }
            output[i] = activation.of(sum);
        }
        return output;
    }

    double[] row(int output) {
        return Arrays.copyOfRange(numbers, output * (inputs + 1), (output + 1) * (inputs + 1));
    }
}
