package org.robonewbie.agent.policy;

import java.util.Arrays;
import java.util.List;

/**
 * Evaluates a {@link Network} step by step and keeps what its recurrent layers remember. Each robot needs a session of its
 * own.
 *
 * <pre>{@code
 * InferenceSession session = policy.network().session();
 * double[] action = session.apply(observation);   // in each cycle
 * session.reset();                                // when an episode begins
 * }</pre>
 */
public final class InferenceSession {

    private final List<Layer> layers;
    private final double[][] states;
    private final double[][] outputs;

    InferenceSession(List<Layer> layers) {
        this.layers = layers;
        states = layers.stream().map(layer -> new double[layer.stateSize()]).toArray(double[][]::new);
        outputs = layers.stream().map(layer -> new double[layer.outputs()]).toArray(double[][]::new);
    }

    /**
     * Evaluates the network.
     *
     * @param input values of the inputs
     * @return the outputs, each from -1 to 1, as a new array
     */
    public double[] apply(double... input) {
        double[] values = input;
        for (int i = 0; i < outputs.length; i++) {
            layers.get(i).apply(values, states[i], outputs[i]);
            values = outputs[i];
        }
        return values.clone();
    }

    /** Forgets all earlier inputs, as at the start of an episode. */
    public void reset() {
        for (double[] state : states) {
            Arrays.fill(state, 0);
        }
    }
}
