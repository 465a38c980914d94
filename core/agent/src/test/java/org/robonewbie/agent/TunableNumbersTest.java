package org.robonewbie.agent;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.agent.log.Diagnostics;

class TunableNumbersTest {

    @TempDir
    private Path folder;

    private final ByteArrayOutputStream told = new ByteArrayOutputStream();
    private final Diagnostics diagnostics = new Diagnostics(new PrintStream(told, true, StandardCharsets.UTF_8));

    @Test
    void numberHasItsUsualValue() {
        Strider strider = new Strider();

        assertThat(strider.stride).isEqualTo(0.05);
        assertThat(new AgentDriver(strider).numbers())
                .containsExactly(
                        new TunableNumber("stride", 0.05, 0.02, 0.08, 0.05), new TunableNumber("patience", 2, 0, 5, 2));
    }

    @Test
    void robotIsMadeWithOtherNumbers() {
        Strider strider = TunableNumbers.with(Map.of("stride", 0.07), Strider::new);

        assertThat(strider.stride).isEqualTo(0.07);
        assertThat(strider.patience).isEqualTo(2);
        assertThat(new Strider().stride).isEqualTo(0.05);
    }

    @Test
    void numberIsTakenFromTheFile() throws IOException {
        TunableNumbers numbers = ofFile("# made by hand\nstride = 0.06\n");

        assertThat(numbers.declare("stride", 0.05, 0.02, 0.08)).isEqualTo(0.06);
        assertThat(told()).isEmpty();
    }

    @Test
    void numberBeyondItsRangeIsToldAndLimited() throws IOException {
        TunableNumbers numbers = ofFile("stride = 9");

        assertThat(numbers.declare("stride", 0.05, 0.02, 0.08)).isEqualTo(0.08);
        assertThat(told())
                .contains("stride = 9.0 in " + folder.resolve("Walker.numbers")
                        + " is not between 0.02 and 0.08; 0.08 is used.");
    }

    @Test
    void valueThatIsNotANumberIsReported() throws IOException {
        TunableNumbers numbers = ofFile("stride = long\npatience = NaN");

        assertThat(numbers.declare("stride", 0.05, 0.02, 0.08)).isEqualTo(0.05);
        assertThat(numbers.declare("patience", 2, 0, 5)).isEqualTo(2);
        assertThat(told())
                .contains("stride = long in")
                .contains("is not a number")
                .contains("patience = NaN in");
    }

    @Test
    void nameThatNobodyDeclaresIsTold() throws IOException {
        TunableNumbers numbers = ofFile("strid = 0.06");
        numbers.declare("stride", 0.05, 0.02, 0.08);

        numbers.reportUnknown();

        assertThat(told())
                .contains("has a number \"strid\", but the program does not declare it. Did you mean stride?"
                        + " It declares [stride].");
    }

    @Test
    void rangeWithoutTheUsualValueIsRefused() {
        TunableNumbers numbers = TunableNumbers.of(folder.resolve("Nobody").toString(), diagnostics);

        assertThatThrownBy(() -> numbers.declare("stride", 1, 2, 3))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage(
                        "number(\"stride\", 1.0, 2.0, 3.0): expected the default value, then the smallest and the largest"
                                + " value, such as (\"stride\", 5, 0, 10).");
        assertThatThrownBy(() -> numbers.declare("stride", Double.NaN, 0, 1)).hasMessageContaining("NaN");
    }

    private TunableNumbers ofFile(String text) throws IOException {
        Files.writeString(folder.resolve("Walker.numbers"), text);
        return TunableNumbers.of(folder.resolve("Walker").toString(), diagnostics);
    }

    private String told() {
        return told.toString(StandardCharsets.UTF_8);
    }

    private static final class Strider extends Agent {

        private final double stride = number("stride", 0.05, 0.02, 0.08);
        private final double patience = number("patience", 2, 0, 5);
    }
}
