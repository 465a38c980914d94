package org.robonewbie.workshop.load;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(120)
class ExampleLoadTest {

    @Tag("slow")
    @Test
    void measuresEachCycleOfEachRobotAfterTheWarmUp() throws IOException {
        ByteArrayOutputStream printed = new ByteArrayOutputStream();

        new ExampleLoad(0.2, 1).run("SoccerTeam", new PrintStream(printed, true, StandardCharsets.UTF_8));

        assertThat(printed.toString(StandardCharsets.UTF_8).lines())
                .last()
                .asString()
                .matches("\\| `Agent_SoccerTeam` \\| 3 \\| (\\d+\\.\\d+ \\| ){3}\\d+ of 1\\d\\d \\|");
    }
}
