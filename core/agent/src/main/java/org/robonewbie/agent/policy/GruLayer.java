package org.robonewbie.agent.policy;

/**
 * Gated recurrent unit in the form of cuDNN, PyTorch and ONNX (with {@code linear_before_reset}): a layer that remembers
 * its last outputs.
 *
 * @param inputs number of inputs
 * @param outputs number of outputs
 * @param activation applied to each output; what is remembered precedes it
 * @param numbers parameters: for each output of the reset gate, the update gate and the candidate, in this order, the bias
 *     of the inputs, the bias of the last outputs, the weight of each input and the weight of each last output
 */
@SuppressWarnings("ArrayRecordComponent")
record GruLayer(int inputs, int outputs, Activation activation, double[] numbers) implements Layer {

    static final String NAME = "gru";

    private static final int GATES = 3;

    GruLayer {
        numbers = numbers.clone();
        Layer.requireSize(table(inputs, outputs), numbers);
    }

    static Table table(int inputs, int outputs) {
        return new Table(GATES * outputs, 2, inputs + outputs);
    }

    @Override
    public Table table() {
        return table(inputs, outputs);
    }

    @Override
    public String kind() {
        return NAME;
    }

    @Override
    public int stateSize() {
        return outputs;
    }

    @Override
    public void apply(double[] input, double[] state, double[] output) {
        for (int i = 0; i < outputs; i++) {
            double reset = Activation.sigmoid(ofInput(i, input) + ofState(i, state));
            double update = Activation.sigmoid(ofInput(outputs + i, input) + ofState(outputs + i, state));
            int row = 2 * outputs + i;
            double candidate = Activation.TANH.of(ofInput(row, input) + reset * ofState(row, state));
            output[i] = (1 - update) * candidate + update * state[i];
        }
        System.arraycopy(output, 0, state, 0, outputs);
        for (int i = 0; i < outputs; i++) {
            output[i] = activation.of(output[i]);
        }
    }

    private double ofInput(int row, double... input) {
        int first = row * (2 + inputs + outputs);
        double sum = numbers[first];
        for (int j = 0; j < inputs; j++) {
            sum += numbers[first + 2 + j] * input[j];
        }
        return sum;
    }

    private double ofState(int row, double... state) {
        int first = row * (2 + inputs + outputs);
        double sum = numbers[first + 1];
        for (int j = 0; j < outputs; j++) {
            sum += numbers[first + 2 + inputs + j] * state[j];
        }
        return sum;
    }
}
