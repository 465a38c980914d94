package org.robonewbie.app.policy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.agent.policy.InferenceSession;
import org.robonewbie.agent.policy.file.PolicyFile;
import org.robonewbie.app.ProcessResult;
import org.robonewbie.app.Python;

/** Policies made from ONNX models, beside onnxruntime. */
@Tag("slow")
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "the launcher of this test is a shell script")
class OnnxActionsTest {

    private static final int INPUTS = 12;
    private static final double RELATIVE = 1e-4;
    private static final double FLOAT32 = 1e-6;

    @TempDir
    private Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"linear", "relu", "elu", "silu", "tanh", "layer-norm", "gru"})
    void javaActsAsOnnxruntime(String kind) throws Exception {
        Python python = new Python(folder);
        python.skipWithout("onnx, onnxruntime, gymnasium");
        Path script = Path.of(Objects.requireNonNull(OnnxActionsTest.class.getResource("onnx-actions.py"))
                .toURI());

        ProcessResult result = python.run(script.toString(), kind, "my.policy", "table");

        assertThat(result.code()).as(result.printed()).isZero();
        InferenceSession session =
                PolicyFile.read(folder.resolve("my.policy")).network().session();
        List<String> lines = Files.readAllLines(folder.resolve("table"));
        assertThat(lines).hasSize(1000);
        for (String line : lines) {
            double[] numbers = Arrays.stream(line.split("\t"))
                    .mapToDouble(Double::parseDouble)
                    .toArray();
            double[] action = session.apply(Arrays.copyOf(numbers, INPUTS));
            for (int i = 0; i < action.length; i++) {
                double wanted = numbers[INPUTS + i];
                assertThat(action[i]).isCloseTo(wanted, within(RELATIVE * Math.abs(wanted) + FLOAT32));
            }
        }
    }
}
