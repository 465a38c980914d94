package org.robonewbie.agent.policy;

import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;
import org.robonewbie.nao.math.PortableMath;

/** Activation function of a layer. */
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

    static double sigmoid(double sum) {
        return 1 / (1 + PortableMath.exp(-sum));
    }

    /** Returns the activation that a policy's text names. */
    static Activation named(String word) {
        return Arrays.stream(values())
                .filter(activation -> activation.toString().equalsIgnoreCase(word))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("\"" + word + "\" is unknown. Known activations: "
                        + Arrays.stream(values()).map(Activation::toString).collect(Collectors.joining(", ")) + "."));
    }

    /** Returns whether all values lie between -1 and 1, which the outputs of a policy need. */
    boolean isBounded() {
        return this == TANH || this == CUT;
    }

    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }
}
