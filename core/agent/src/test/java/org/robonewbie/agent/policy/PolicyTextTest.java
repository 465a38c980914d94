package org.robonewbie.agent.policy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.zip.Deflater;
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

        assertThat(PolicyText.format(policy)).isEqualTo(TEXT);
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
                    1 0.5 -0.25           | 1 0.5 2,5         | "2,5" is not a number. Write numbers such as -0.25
                    layer 2 2 tanh        | layer 2 x tanh    | "x" is not a whole number.
                    layer 2 2 tanh        | layer 2 2 tanh lstm | "lstm" is unknown. After the activation may stand
                    layer 2 1 cut         | layer 2 1 cut layer-norm 1e-5 | if there are as many inputs as outputs
                    layer 2 2 tanh        | layer 2 2 tanh layer-norm 0 | with a positive epsilon
                    layer 2 2 tanh        | layer 2 2 tanh layer-norm 1 | A bias and a factor are needed, not 3 numbers.
                    layer 2 2 tanh        | layer 2 2 tanh gru | 2 biases and 4 weights are needed, not 3 numbers.
                    layer 2 2 tanh        | layer 1024 1024 tanh gru | more than 4000000 weights
                    layer 2 2 tanh        | layer 2 2 tanh packed 0 | "packed 0" is unknown.
                    layer 2 2 tanh        | layer 2 2 tanh packed 1 | " " does not occur in packed weights. Write the policy again
                    input tilt 10 degrees | # nothing         | The network has 2 inputs and 1 outputs, but 1 inputs
                    """)
    void saysWhatIsWrong(String line, String instead, String message) {
        assertThatThrownBy(() -> PolicyText.parse(TEXT.replace(line, instead)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(message);
    }

    @Test
    void writesOtherKindsOfLayersAsItHasReadThem() {
        String text = """
                policy 1 balance
                input tilt 10 degrees
                output KNEE 20 degrees
                layer 1 1 elu layer-norm 1.0E-5
                0.5 0.25
                layer 1 1 linear gru
                0.1 0.2 0.3 0.4
                -0.5 0.6 0.7 -0.8
                0.9 1 1.1 -1.2
                layer 1 1 tanh
                0 1
                """;

        assertThat(PolicyText.format(PolicyText.parse(text))).isEqualTo(text);
    }

    @Test
    void readsPackedWeights() {
        assertThat(PolicyText.parse(packed(packed(1, -3))).network().numbers()).containsExactly(0.5, 0.125, -0.75);
    }

    /** Packs a bias of 0.5 and two weights: integers by a step of 0.125, of which the second has the exponent 1. */
    private static byte[] packed(int... integers) {
        ByteBuffer bytes = ByteBuffer.allocate(2 + 8 + 6).order(ByteOrder.LITTLE_ENDIAN);
        bytes.put((byte) 0).put((byte) 1).putFloat(0.5f).putFloat(0.125f);
        for (int shift = 0; shift < 24; shift += 8) {
            for (int integer : integers) {
                bytes.put((byte) ((integer << 1 ^ integer >> 31) >> shift));
            }
        }
        return bytes.array();
    }

    private static String packed(byte... bytes) {
        Deflater deflater = new Deflater();
        deflater.setInput(bytes);
        deflater.finish();
        byte[] compressed = new byte[100_000];
        int length = deflater.deflate(compressed);
        deflater.end();
        return head("layer 2 1 tanh packed 1") + base85(Arrays.copyOf(compressed, length)) + "\n";
    }

    private static String head(String layer) {
        return "policy 1 balance\ninput a 1\ninput b 1\noutput KNEE 20 degrees\n" + layer + "\n";
    }

    private static String base85(byte... bytes) {
        String digits = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#$%&()*+-;<=>?@^_`{|}~";
        StringBuilder text = new StringBuilder();
        ByteBuffer groups = ByteBuffer.wrap(Arrays.copyOf(bytes, (bytes.length + 3) / 4 * 4));
        while (groups.hasRemaining()) {
            long group = groups.getInt() & 0xFFFF_FFFFL;
            for (long place = 85L * 85 * 85 * 85; place > 0; place /= 85) {
                text.append(digits.charAt((int) (group / place % 85)));
            }
        }
        return text.substring(0, text.length() - (4 - bytes.length % 4) % 4);
    }

    @Test
    void refusesDamagedPackedWeights() {
        String text = packed(packed(1, -3));
        int last = text.length() - 2;

        assertRefused(text.substring(0, last - 4) + "\n", "are packed. Write the policy again");
        assertRefused(text.substring(0, last) + "~\n", "packed");
        assertRefused(head("layer 2 1 tanh packed 1") + "~~~~~\n", "\"~~~~~\" stands for no bytes.");
        assertRefused(head("layer 2 1 tanh packed 1") + "0000000000\n", "The packed weights are damaged.");
        assertRefused(head("layer 2 1 tanh packed 1") + "ä\n", "\"ä\" does not occur in packed weights.");
        assertRefused(packed(new byte[15]), "The layer needs 16 bytes, but 15 are packed.");
        assertRefused(packed(new byte[50_000_000]), "The layer needs 16 bytes, but more are packed.");
        assertRefused(head("layer 2 1 tanh packed 2") + "abc", "The policy \"balance\" is incomplete.");
        byte[] infinite = packed(1, -3);
        infinite[5] = 0x7F;
        infinite[4] = (byte) 0x80;
        assertRefused(packed(infinite), "All numbers must be finite.");
    }

    private static void assertRefused(String text, String message) {
        assertThatThrownBy(() -> PolicyText.parse(text))
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
