package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class MainTest {

    @Test
    void helpListsAllCommands() {
        Printed help = Printed.by("--help");

        assertThat(help.exitCode()).isZero();
        assertThat(help.out()).contains("demo", "run", "simulator", "studio", "fidelity", "doctor");
    }

    @ParameterizedTest
    @ValueSource(strings = {"demo", "run", "simulator", "studio", "fidelity", "doctor"})
    void everyCommandHasHelpWithExamples(String command) {
        Printed help = Printed.by(command, "--help");

        assertThat(help.exitCode()).isZero();
        assertThat(help.out()).contains("Examples:", "  robonewbie " + command);
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
                .contains("There is no command \"simulatr\". Did you mean simulator?")
                .contains("\"robonewbie --help\" shows");
    }

    @Test
    void unknownOptionIsAnsweredWithTheNearest() {
        Printed answer = Printed.by("simulator", "--agnet-port", "3100");

        assertThat(answer.exitCode()).isEqualTo(2);
        assertThat(answer.err()).contains("The option --agnet-port is unknown. Did you mean --agent-port?");
    }

    @Test
    void wordsThatBelongNowhereAreRefused() {
        Printed answer = Printed.by("doctor", "who");

        assertThat(answer.exitCode()).isEqualTo(2);
        assertThat(answer.err()).contains("\"who\" is too much here.");
    }

    @Test
    void valueThatIsNoNumberIsNamed() {
        Printed answer = Printed.by("simulator", "--agent-port", "abc");

        assertThat(answer.exitCode()).isEqualTo(2);
        assertThat(answer.err()).contains("--agent-port", "\"abc\" is not a whole number");
    }

    @Test
    void studioSaysThatItCannotOpenFilesYet() {
        Printed answer = Printed.by("studio", "run.rec");

        assertThat(answer.exitCode()).isEqualTo(2);
        assertThat(answer.err()).contains("The studio cannot open run.rec yet");
    }

    @Test
    void folderOfRecordingsThatIsMissingIsNamed() {
        Printed answer = Printed.by("fidelity", "nowhere");

        assertThat(answer.exitCode()).isEqualTo(2);
        assertThat(answer.err()).contains("nowhere is not a folder");
    }
}
