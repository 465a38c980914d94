package org.robonewbie.agent.policy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class NetworkTest {

    @Test
    void calculatesLayerAfterLayer() {
        Network network = Network.of(new int[] {2, 1, 1}, 0.5, 1, -2, 0.1, 3);

        double answer = network.apply(0.3, 0.2)[0];

        assertThat(answer).isCloseTo(Math.tanh(0.1 + 3 * Math.tanh(0.5 + 0.3 - 0.4)), within(1e-12));
    }

    @Test
    void pressesTheLargestSumsBetweenOneAndMinusOne() {
        Network network = Network.of(new int[] {1, 1}, 0, 1);

        assertThat(network.apply(1e6)[0]).isEqualTo(1);
        assertThat(network.apply(-1e6)[0]).isEqualTo(-1);
    }

    @Test
    void cutsOffWhatIsBeyondOne() {
        Network network = new Network(List.of(new DenseLayer(1, 1, Activation.CUT, new double[] {0.25, 1})));

        assertThat(network.apply(0.5)[0]).isEqualTo(0.75);
        assertThat(network.apply(5)[0]).isEqualTo(1);
    }

    @ParameterizedTest
    @CsvSource({
        "RELU, 0.7, 0.7",
        "RELU, -0.7, 0",
        "ELU, 0.7, 0.7",
        "ELU, -0.7, -0.503414696",
        "ELU, -800, -1",
        "SILU, 0.7, 0.467731441",
        "SILU, -0.7, -0.232268559",
        "SILU, -800, 0",
        "LINEAR, -3, -3"
    })
    void activationsAreThoseOfTheLiterature(Activation activation, double sum, double value) {
        Layer layer = new DenseLayer(1, 1, activation, new double[] {0, 1});

        assertThat(new Network(List.of(layer)).apply(sum)[0]).isCloseTo(value, within(1e-9));
    }

    @Test
    void layerNormalisationHasTheMeanAndTheVarianceOfItsInputs() {
        Network network =
                new Network(List.of(new LayerNormalization(2, 0.5, Activation.LINEAR, new double[] {0, 1, 10, 3})));

        assertThat(network.apply(1, 4))
                .containsExactly(new double[] {-1.5 / Math.sqrt(2.75), 10 + 4.5 / Math.sqrt(2.75)}, within(1e-12));
    }

    @Test
    void recurrentLayerRemembersUntilItIsReset() {
        double[] numbers = {0.1, 0.2, 0.3, 0.4, -0.5, 0.6, 0.7, -0.8, 0.9, 1, 1.1, -1.2};
        InferenceSession session = new Network(List.of(new GruLayer(1, 1, Activation.LINEAR, numbers))).session();
        double first = gru(2, 0);

        assertThat(session.apply(2)[0]).isCloseTo(first, within(1e-12));
        assertThat(session.apply(-1)[0]).isCloseTo(gru(-1, first), within(1e-12));
        session.reset();
        assertThat(session.apply(2)[0]).isCloseTo(first, within(1e-12));
    }

    /** The formula of PyTorch's documentation. */
    private static double gru(double x, double h) {
        double reset = 1 / (1 + Math.exp(-(0.1 + 0.3 * x + 0.2 + 0.4 * h)));
        double update = 1 / (1 + Math.exp(-(-0.5 + 0.7 * x + 0.6 - 0.8 * h)));
        double candidate = Math.tanh(0.9 + 1.1 * x + reset * (1 - 1.2 * h));
        return (1 - update) * candidate + update * h;
    }

    @Test
    void refusesTooFewNumbers() {
        assertThatThrownBy(() -> Network.of(new int[] {2, 3}, 1, 2))
                .hasMessage("A network with layers of [2, 3] needs 9 numbers, not 2.");
    }

    @Test
    void refusesLayersThatDoNotFit() {
        DenseLayer layer = new DenseLayer(1, 2, Activation.TANH, new double[4]);

        assertThatThrownBy(() -> new Network(List.of(layer, layer)))
                .hasMessage("Layer 2 has 1 inputs, but the previous layer has 2 outputs.");
    }
}
