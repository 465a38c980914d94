package org.robonewbie.agent.policy;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * A learned policy: a network, the names and units of its inputs and outputs, and parameters of the behaviour that the
 * network corrects, such as a gait. {@link PolicyText} defines the text format.
 *
 * <pre>{@code
 * Policy policy = PolicyFile.shipped("walk");
 * walk.setPolicy(new PolicyWalk(policy));
 * walk.towards(0.8, 0, 0);
 * }</pre>
 *
 * @param task name of the task, such as {@code walk}
 * @param about remarks on the training
 * @param numbers parameter lists of the corrected behaviour by name
 * @param inputs inputs of the network
 * @param outputs outputs of the network
 * @param network the network
 */
public record Policy(
        String task,
        List<String> about,
        Map<String, List<Double>> numbers,
        List<Quantity> inputs,
        List<Quantity> outputs,
        Network network) {

    /** Name of the parameter that sets the number of cycles for which each action is held (default: 1). */
    public static final String CYCLES_PER_ACTION = "cycles-per-action";

    /**
     * Copies the collections and checks the numbers of inputs and outputs.
     *
     * @throws IllegalArgumentException if they do not match the network
     */
    public Policy {
        about = List.copyOf(about);
        numbers = new TreeMap<>(numbers);
        inputs = List.copyOf(inputs);
        outputs = List.copyOf(outputs);
        if (network.inputs() != inputs.size() || network.outputs() != outputs.size()) {
            throw new IllegalArgumentException("The network has " + network.inputs() + " inputs and "
                    + network.outputs() + " outputs, but " + inputs.size() + " inputs and " + outputs.size()
                    + " outputs are named.");
        }
    }

    /**
     * Looks up a parameter list.
     *
     * @param name name of the list
     * @param count expected number of parameters
     * @return the parameters
     * @throws IllegalArgumentException if there is no such list, or its length is not {@code count}
     */
    public double[] numbers(String name, int count) {
        List<Double> found = numbers.getOrDefault(name, List.of());
        if (found.size() != count) {
            throw new IllegalArgumentException("The policy \"" + task + "\" needs " + count + " numbers named \"" + name
                    + "\", but has " + found.size() + ".");
        }
        return found.stream().mapToDouble(Double::doubleValue).toArray();
    }

    /** {@return the number of cycles of 20 ms for which an action is held, at least 1} */
    public int cyclesPerAction() {
        return numbers.containsKey(CYCLES_PER_ACTION) ? Math.max(1, (int) numbers(CYCLES_PER_ACTION, 1)[0]) : 1;
    }

    /**
     * Checks that the policy has the expected inputs and outputs.
     *
     * @param wantedInputs the expected inputs
     * @param wantedOutputs the expected outputs
     * @throws IllegalArgumentException if the inputs or outputs differ; the message describes the first difference
     */
    public void require(List<Quantity> wantedInputs, List<Quantity> wantedOutputs) {
        require("input", inputs, wantedInputs);
        require("output", outputs, wantedOutputs);
    }

    private void require(String kind, List<Quantity> found, List<Quantity> wanted) {
        int different = Arrays.mismatch(found.toArray(), wanted.toArray());
        if (different >= 0) {
            throw new IllegalArgumentException(
                    "The policy \"" + task + "\" has " + at(found, different) + " as " + kind + " " + (different + 1)
                            + " where " + at(wanted, different) + " is needed. Was the policy trained for another"
                            + " task?");
        }
    }

    private static String at(List<Quantity> all, int index) {
        return index < all.size()
                ? all.get(index).name() + " in " + all.get(index).unit()
                : "nothing";
    }
}
