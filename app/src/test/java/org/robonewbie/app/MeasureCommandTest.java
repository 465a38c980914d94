package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
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
    void saysWhatCanBeMeasured() {
        MeasureCommand command = command("mountains");

        assertThatThrownBy(command::call)
                .isInstanceOf(CalledWronglyException.class)
                .hasMessage("\"mountains\" cannot be measured; write: robonewbie measure motions");
    }

    private static MeasureCommand command(String... arguments) {
        MeasureCommand command = new MeasureCommand();
        new CommandLine(command).parseArgs(arguments);
        return command;
    }
}
