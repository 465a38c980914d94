package org.robonewbie.agent.policy;

/**
 * Fully connected layer: each output is the activation of a weighted sum of all inputs and a bias.
 *
 * @param inputs number of inputs
 * @param outputs number of outputs
 * @param activation applied to each sum
 * @param numbers parameters: for each output, its bias and then the weight of each input
 */
@SuppressWarnings("ArrayRecordComponent")
record DenseLayer(int inputs, int outputs, Activation activation, double[] numbers) implements Layer {

    DenseLayer {
        numbers = numbers.clone();
        Layer.requireSize(table(inputs, outputs), numbers);
    }

    static Table table(int inputs, int outputs) {
        return new Table(outputs, 1, inputs);
    }

    @Override
    public Table table() {
        return table(inputs, outputs);
    }

    @Override
    public String kind() {
        return "";
    }

    @Override
    public void apply(double[] input, double[] state, double[] output) {
        for (int i = 0; i < outputs; i++) {
            int first = i * (inputs + 1);
            double sum = numbers[first];
            for (int j = 0; j < inputs; j++) {
                sum += numbers[first + 1 + j] * input[j];
            }
            output[i] = activation.of(sum);
        }
    }
}
