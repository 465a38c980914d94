package org.robonewbie.workshop.team;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

class AgentMeasurementTest {

    @Tag("slow")
    @Test
    void letsTheExampleAgentsPlayAndPrintsHowWellTheyDo() throws IOException {
        ByteArrayOutputStream printed = new ByteArrayOutputStream();
        AgentMeasurement measurement =
                new AgentMeasurement(1, 1, new PrintStream(printed, true, StandardCharsets.UTF_8));

        measurement.run("BetterSoccer", Optional.empty());
        measurement.run("WalkToBall", Optional.empty());

        assertThat(printed.toString(StandardCharsets.UTF_8))
                .containsPattern("`Agent_SimpleWalkToBall` \\| 1 of 1 \\| [0-9.]+ s")
                .containsPattern("`Agent_BetterSoccer` \\| 1 of 1 \\| [0-9.]+ s");
    }
}
