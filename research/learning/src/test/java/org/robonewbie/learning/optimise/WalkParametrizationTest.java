package org.robonewbie.learning.optimise;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class WalkParametrizationTest {

    @TempDir
    private Path folder;

    private final WalkParametrization engine = new WalkParametrization(NamedObjective.named("walk-speed"));

    @Test
    void theShippedWalkIsAsFastAsWeSay() {
        Evaluation evaluation = engine.evaluate(new double[engine.dimension()], 1);

        assertThat(evaluation.success()).isEqualTo(1);
        assertThat(evaluation.value()).isCloseTo(0.57, within(0.05));
    }

    @Test
    void writesTheNumbersForTheWalksSource() throws IOException {
        Path file = folder.resolve("walk.txt");

        engine.save(new double[engine.dimension()], Map.of("made by", "test"), file);

        assertThat(Files.readString(file)).startsWith("// made by: test\n2.10, -1.50, 1.10");
    }

    @Test
    void namesItsNumbers() {
        assertThat(engine.numbers(new double[engine.dimension()]))
                .hasSize(engine.dimension())
                .first()
                .isEqualTo(new Parameter("gait: height of the torso", "", 2.1, 0.5));
    }
}
