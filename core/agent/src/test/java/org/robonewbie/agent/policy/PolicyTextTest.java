package org.robonewbie.agent.policy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PolicyTextTest {

    private static final String TEXT = """
            policy 1 balance
            # learned on a Monday
            numbers range 20 -0.5
            input gyro.forward degrees/s
            input tilt 10 degrees
            output KNEE 20 degrees
            layer 2 2 tanh
            1 0.5 -0.25
            0.125 2 3
            layer 2 1 cut
            0 1 -1
            """;

    @Test
    void writesWhatItHasRead() {
        Policy policy = PolicyText.parse(TEXT);

        assertThat(PolicyText.format(policy))
                .isEqualTo(TEXT.replace("0.5", "0.500000")
                        .replace("0.25", "0.250000")
                        .replace("0.125", "0.125000"));
        assertThat(PolicyText.parse(PolicyText.format(policy)).network().numbers())
                .containsExactly(policy.network().numbers());
    }

    @Test
    void readsNamesUnitsAndNumbers() {
        Policy policy = PolicyText.parse(TEXT);

        assertThat(policy.task()).isEqualTo("balance");
        assertThat(policy.about()).containsExactly("learned on a Monday");
        assertThat(policy.numbers("range", 2)).containsExactly(20, -0.5);
        assertThat(policy.inputs())
                .containsExactly(new Quantity("gyro.forward", "degrees/s"), new Quantity("tilt", "10 degrees"));
        assertThat(policy.network().apply(0, 0)[0])
                .isEqualTo(Math.tanh(1) - Math.tanh(0.125), org.assertj.core.api.Assertions.within(1e-12));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                    policy 1 balance      | policy 7 balance  | Line 1 of the policy cannot be read
                    layer 2 2 tanh        | layer 2 2 sigmoid | Known activations: tanh, cut, relu, elu, silu, linear.
                    layer 2 1 cut         | layer 2 1 elu     | its outputs must lie between -1 and 1: use tanh or cut.
                    1 0.5 -0.25           | 1 0.5             | A bias and 2 weights are needed, not 2 numbers.
                    1 0.5 -0.25           | 1 NaN 2           | All numbers must be finite.
                    0 1 -1                | # nothing         | The policy "balance" is incomplete.
                    input tilt 10 degrees | weather fine x    | Known statements: numbers, input, output, layer.
                    input tilt 10 degrees | input tilt        | The line is incomplete.
                    layer 2 2 tanh        | layer 2 1025 tanh | A layer has 1 to 1024 inputs and outputs
                    layer 2 2 tanh        | layer 2 0 tanh    | A layer has 1 to 1024 inputs and outputs
                    input tilt 10 degrees | # nothing         | The network has 2 inputs and 1 outputs, but 1 inputs
                    """)
    void saysWhatIsWrong(String line, String instead, String message) {
        assertThatThrownBy(() -> PolicyText.parse(TEXT.replace(line, instead)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(message);
    }

    @Test
    void policyKnowsWhetherItIsForSomethingElse() {
        Policy policy = PolicyText.parse(TEXT);

        policy.require(policy.inputs(), policy.outputs());

        assertThatThrownBy(() -> policy.require(policy.inputs(), List.of(new Quantity("ELBOW", "20 degrees"))))
                .hasMessage(
                        "The policy \"balance\" has KNEE in 20 degrees as output 1 where ELBOW in 20 degrees is needed."
                                + " Was the policy trained for another task?");
        assertThatThrownBy(() -> policy.numbers("gait", 38))
                .hasMessage("The policy \"balance\" needs 38 numbers named \"gait\", but has 0.");
        assertThatThrownBy(() -> new Policy("x", List.of(), Map.of(), List.of(), List.of(), policy.network()))
                .hasMessageContaining("0 inputs and 0 outputs are named");
    }
}
