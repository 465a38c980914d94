package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robonewbie.app.command.RoboNewbieCommand;

class MainTest {

    @Test
    void helpListsAllCommands() {
        Printed help = Printed.by("--help");

        assertThat(help.exitCode()).isZero();
        assertThat(help.out()).contains("demo", "run", "simulator", "studio", "doctor");
    }

    static Set<String> commands() {
        return RoboNewbieCommand.commandLine().getSubcommands().keySet();
    }

    @ParameterizedTest
    @MethodSource("commands")
    void listOfCommandsTellsEachInAWholeSentence(String command) {
        assertThat(Objects.requireNonNull(
                                RoboNewbieCommand.commandLine().getSubcommands().get(command))
                        .getCommandSpec()
                        .usageMessage()
                        .description()[0])
                .endsWith(".");
    }

    @ParameterizedTest
    @MethodSource("commands")
    void everyCommandHasHelpWithExamples(String command) {
        Printed help = Printed.by(command, "--help");

        assertThat(help.exitCode()).isZero();
        assertThat(help.out()).contains("Examples:", "  robonewbie " + command);
    }

    @Test
    void wordHelpShowsTheHelp() {
        assertThat(Printed.by("help")).isEqualTo(Printed.by("--help"));
        assertThat(Printed.by("help", "grade")).isEqualTo(Printed.by("grade", "--help"));
        assertThat(Printed.by("help", "graed").err()).contains("Did you mean grade?");
    }

    @Test
    void helpOfRunListsTheOptionsOfAgents() {
        assertThat(Printed.by("run", "--help").out()).contains("--host", "--seconds", "--pose");
    }

    @Test
    void helpOfSimulatorListsAllSoccerParameters() {
        assertThat(Printed.by("simulator", "--help").out()).contains("RuleHalfTime", "BeamNoiseXY", "FieldLength");
    }

    @Test
    void versionNamesProgramAndJava() {
        assertThat(Printed.by("--version").out()).contains("RoboNewbie", "Java " + Runtime.version());
    }

    @Test
    void unknownCommandIsAnsweredWithTheNearest() {
        Printed answer = Printed.by("simulatr");

        assertThat(answer.exitCode()).isEqualTo(2);
        assertThat(answer.err())
                .contains("Unknown command \"simulatr\". Did you mean simulator?")
                .contains("\"robonewbie --help\" shows");
    }

    @Test
    void unknownOptionIsAnsweredWithTheNearest() {
        Printed answer = Printed.by("simulator", "--agnet-port", "3100");

        assertThat(answer.exitCode()).isEqualTo(2);
        assertThat(answer.err()).contains("Unknown option --agnet-port. Did you mean --agent-port?");
    }

    @Test
    void wordsThatBelongNowhereAreRefused() {
        Printed answer = Printed.by("doctor", "who");

        assertThat(answer.exitCode()).isEqualTo(2);
        assertThat(answer.err()).contains("Unexpected argument \"who\".");
    }

    @Test
    void valueThatIsNoNumberIsNamed() {
        Printed answer = Printed.by("simulator", "--agent-port", "abc");

        assertThat(answer.exitCode()).isEqualTo(2);
        assertThat(answer.err()).contains("--agent-port", "\"abc\" is not a whole number");
    }

    @Test
    void studioSaysThatThereIsNoSuchFile() {
        Printed answer = Printed.by("studio", "nowhere.rec");

        assertThat(answer.exitCode()).isEqualTo(2);
        assertThat(answer.err()).contains("There is no file").contains("nowhere.rec\". Check the name.");
    }

    @Test
    void studioSaysWhatFilesItOpens(@TempDir Path folder) throws IOException {
        Path file = Files.writeString(folder.resolve("picture.png"), "no recording");

        Printed answer = Printed.by("studio", file.toString());

        assertThat(answer.exitCode()).isEqualTo(2);
        assertThat(answer.err())
                .contains("picture.png\" is not a server log: it contains no complete scene.")
                .contains("It opens recordings (.rec), logs of SimSpark servers and of RCSSServerMJ, motions");
    }

    @Test
    void studioSaysHowToNameAMonitorPort() {
        Printed answer = Printed.by("studio", "--monitor", "127.0.0.1:many");

        assertThat(answer.exitCode()).isEqualTo(2);
        assertThat(answer.err())
                .contains("\"127.0.0.1:many\" is not a monitor address. Write HOST:PORT, such as 127.0.0.1:3200.");
    }
}
