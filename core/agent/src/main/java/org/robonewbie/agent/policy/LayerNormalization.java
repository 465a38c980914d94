package org.robonewbie.agent.policy;

/**
 * Layer normalisation (Ba et al. 2016, <a href="https://arxiv.org/abs/1607.06450">Layer Normalization</a>): shifts and scales all values to a mean of
 * 0 and a variance of 1, then scales and shifts each one.
 *
 * @param outputs number of inputs, which is that of the outputs
 * @param epsilon added to the variance
 * @param activation applied to each value
 * @param numbers parameters: for each output, its bias and then its factor
 */
@SuppressWarnings("ArrayRecordComponent")
record LayerNormalization(int outputs, double epsilon, Activation activation, double[] numbers) implements Layer {

    static final String NAME = "layer-norm";

    LayerNormalization {
        numbers = numbers.clone();
        Layer.requireSize(table(outputs), numbers);
    }

    static Table table(int outputs) {
        return new Table(outputs, 2, 0);
    }

    @Override
    public int inputs() {
        return outputs;
    }

    @Override
    public Table table() {
        return table(outputs);
    }

    @Override
    public String kind() {
        return NAME + " " + epsilon;
    }

    @Override
    public void apply(double[] input, double[] state, double[] output) {
        double mean = 0;
        for (int i = 0; i < outputs; i++) {
            mean += input[i] / outputs;
        }
        double variance = 0;
        for (int i = 0; i < outputs; i++) {
            variance += (input[i] - mean) * (input[i] - mean) / outputs;
        }
        double deviation = Math.sqrt(variance + epsilon);
        for (int i = 0; i < outputs; i++) {
            output[i] = activation.of((input[i] - mean) / deviation * numbers[2 * i + 1] + numbers[2 * i]);
        }
    }
}
