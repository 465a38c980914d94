package org.robonewbie.agent.policy;

import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;
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

    /** Activation function. */
    enum Activation {
        /** Hyperbolic tangent: between -1 and 1. */
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
        },
        /** Rectified linear unit: 0 for negative sums. */
        RELU {
            @Override
            double of(double sum) {
                return Math.max(0, sum);
            }
        },
        /** Exponential linear unit: approaches -1 for negative sums. */
        ELU {
            @Override
            double of(double sum) {
                return sum > 0 ? sum : PortableMath.exp(sum) - 1;
            }
        },
        /** Sigmoid linear unit, also called swish. */
        SILU {
            @Override
            double of(double sum) {
                return sum / (1 + PortableMath.exp(-sum));
            }
        },
        /** No activation: the sum. */
        LINEAR {
            @Override
            double of(double sum) {
                return sum;
            }
        };

        abstract double of(double sum);

        /** Returns whether all values lie between -1 and 1, which the outputs of a policy need. */
        boolean isBounded() {
            return this == TANH || this == CUT;
        }

        /** Returns the names of all activation functions in a policy's text. */
        static String names() {
            return Arrays.stream(values()).map(Activation::toString).collect(Collectors.joining(", "));
        }

        @Override
        public String toString() {
            return name().toLowerCase(Locale.ROOT);
        }
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
