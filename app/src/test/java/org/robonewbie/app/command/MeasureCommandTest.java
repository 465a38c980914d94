package org.robonewbie.app.command;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.robonewbie.programs.CalledWronglyException;
import picocli.CommandLine;

class MeasureCommandTest {

    @Test
    void refusesToMeasureWithoutTrials() {
        MeasureCommand command = command("motions", "--seeds", "0");

        assertThatThrownBy(command::call)
                .isInstanceOf(CalledWronglyException.class)
                .hasMessage("--seeds 0: give a number of trials of at least 1.");
    }

    @Test
    void saysWhoTheOthersCanBe() {
        MeasureCommand command = command("team", "--against", "Agent_Nobody");

        assertThatThrownBy(command::call)
                .isInstanceOf(CalledWronglyException.class)
                .hasMessage("--against Agent_Nobody: write Agent_BetterSoccer or Agent_Team.");
    }

    @Tag("slow")
    @Test
    void letsTheExampleAgentsPlayAndPrintsHowWellTheyDo() throws IOException {
        ByteArrayOutputStream printed = new ByteArrayOutputStream();
        AgentMeasurement measurement =
                new AgentMeasurement(1, 1, new PrintStream(printed, true, StandardCharsets.UTF_8));

        measurement.run("BetterSoccer", Optional.empty());
        measurement.run("WalkToBall", Optional.empty());

        assertThat(printed.toString(StandardCharsets.UTF_8))
                .containsPattern("Agent_SimpleWalkToBall +1 +1 +[0-9.]+ s")
                .containsPattern("Agent_BetterSoccer +1 +1 +[0-9.]+ s");
    }

    private static MeasureCommand command(String subject, String... arguments) {
        CommandLine command = MeasureCommand.of(subject);
        command.parseArgs(arguments);
        return (MeasureCommand) command.getCommandSpec().userObject();
    }
}
