package org.robonewbie.app.command;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.robonewbie.app.Printed;
import org.robonewbie.programs.CalledWronglyException;
import picocli.CommandLine;

class BenchmarkCommandTest {

    @Test
    void refusesMoreRobotsThanTwoTeamsHave() {
        assertThatThrownBy(command("--robots", "1,23")::call)
                .isInstanceOf(CalledWronglyException.class)
                .hasMessage("--robots 23 is not possible. Two teams have 1 to 22 robots.");
    }

    @Test
    void refusesToMeasureNoTime() {
        assertThatThrownBy(command("--seconds", "0")::call)
                .isInstanceOf(CalledWronglyException.class)
                .hasMessage("--seconds 0.0 is not possible. Give simulated seconds above 0, such as 20.");
    }

    @Test
    void refusesAPortThatDoesNotExist() {
        assertThatThrownBy(command("--host", "localhost", "--port", "70000")::call)
                .isInstanceOf(CalledWronglyException.class)
                .hasMessage("--port 70000 does not exist. Ports are 1 to 65535.");
    }

    @Test
    void refusesToMeasureWhatItCannotWrite() {
        assertThatThrownBy(command("--json", "no/such/folder/figures.json")::call)
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageContaining("The results cannot be written to the folder");
    }

    @Test
    void tellsHowToMeasureARealServer() {
        assertThat(Printed.by("bench", "speed", "--help").out())
                .contains("$agentSyncMode = true")
                .contains("pidof rcssserver3d");
    }

    private static BenchmarkCommand command(String... arguments) {
        BenchmarkCommand command = new BenchmarkCommand();
        new CommandLine(command).parseArgs(arguments);
        return command;
    }
}
