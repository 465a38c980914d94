package org.robonewbie.agent.policy;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * What a robot has learned: a network, what its inputs and outputs mean, and the numbers of what it corrects, such as those of a
 * gait. {@link PolicyText} writes it as a text that people can read.
 *
 * <pre>{@code
 * Policy policy = PolicyFile.shipped("walk");
 * walk.setPolicy(new PolicyWalk(policy));
 * walk.towards(0.8, 0, 0);
 * }</pre>
 *
 * @param task what was learned, such as {@code walk}
 * @param about how it was learned: lines for people
 * @param numbers other numbers by name
 * @param inputs what the network takes
 * @param outputs what the network gives
 * @param network the network
 */
public record Policy(
        String task,
        List<String> about,
        Map<String, List<Double>> numbers,
        List<Quantity> inputs,
        List<Quantity> outputs,
        Network network) {

    /** The name of the number that says how many cycles an action lasts, if it lasts more than one. */
    public static final String CYCLES_PER_ACTION = "cycles-per-action";

    /**
     * Copies the lists and counts inputs and outputs.
     *
     * @throws IllegalArgumentException if the network takes or gives another number of numbers
     */
    public Policy {
        about = List.copyOf(about);
        numbers = new TreeMap<>(numbers);
        inputs = List.copyOf(inputs);
        outputs = List.copyOf(outputs);
        if (network.inputs() != inputs.size() || network.outputs() != outputs.size()) {
            throw new IllegalArgumentException("The network takes " + network.inputs() + " numbers and gives "
                    + network.outputs() + ", but " + inputs.size() + " inputs and " + outputs.size()
                    + " outputs have a name.");
        }
    }

    /**
     * Looks numbers up.
     *
     * @param name what they are called
     * @param count how many they have to be
     * @return the numbers
     * @throws IllegalArgumentException if there are none of this name, or not so many
     */
    public double[] numbers(String name, int count) {
        List<Double> found = numbers.getOrDefault(name, List.of());
        if (found.size() != count) {
            throw new IllegalArgumentException("The policy \"" + task + "\" needs " + count + " numbers \"" + name
                    + "\", but has " + found.size() + ".");
        }
        return found.stream().mapToDouble(Double::doubleValue).toArray();
    }

    /** {@return for how many cycles of 20 ms the robot keeps what the network gives, 1 unless it was learned in another way} */
    public int cyclesPerAction() {
        return numbers.containsKey(CYCLES_PER_ACTION) ? Math.max(1, (int) numbers(CYCLES_PER_ACTION, 1)[0]) : 1;
    }

    /**
     * Checks that the network was learned for these inputs and outputs.
     *
     * @param wantedInputs what it will be given
     * @param wantedOutputs what it is expected to give
     * @throws IllegalArgumentException if it was not; the text names the first one that differs
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
                            + " where " + at(wanted, different) + " is needed. Is it for another task?");
        }
    }

    private static String at(List<Quantity> all, int index) {
        return index < all.size()
                ? all.get(index).name() + " in " + all.get(index).unit()
                : "nothing";
    }
}
