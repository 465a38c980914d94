package org.robonewbie.app.command;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.app.Printed;
import org.robonewbie.nao.file.UnreadableFileException;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.sensing.CameraSettings;
import org.robonewbie.simulator.server.SimulatorSettings;
import org.robonewbie.simulator.soccer.SoccerParameter;
import org.robonewbie.simulator.soccer.SoccerParameters;
import picocli.CommandLine;

class SimulatorCommandTest {

    @TempDir
    Path folder = Path.of("");

    @Test
    void withoutOptionsItIsLikeTheOriginalServer() throws IOException {
        SimulatorSettings settings = settings();

        assertThat(settings.agents().port()).isEqualTo(3100);
        assertThat(settings.monitors().port()).hasValue(3200);
        assertThat(settings.agents().bindAddress()).isEqualTo("127.0.0.1");
        assertThat(settings.world().synchronous()).isFalse();
        assertThat(settings.speed()).isEqualTo(1);
        assertThat(settings.world().camera().noise()).isTrue();
        assertThat(settings.world().parameters()).isEqualTo(SoccerParameters.league());
    }

    @Test
    void beginnersGetTheirOwnPitch() throws IOException {
        assertThat(settings("--beginner").world().parameters()).isEqualTo(SoccerParameters.beginner());
    }

    @Test
    void bothProfilesTogetherAreRefused() {
        assertThatThrownBy(() -> settings("--beginner", "--league"))
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageContaining("cannot be combined");
    }

    @Test
    void whatStandsOnThePitchIsChosenByName() throws IOException {
        assertThat(settings().world().landscape()).isSameAs(Landscape.SOCCER);
        assertThat(settings("--scene", "slope").world().landscape()).isSameAs(Landscape.SLOPE);
    }

    @Test
    void unknownSceneIsRefused() {
        assertThatThrownBy(() -> settings("--scene", "moon"))
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageContaining("Choose one of soccer, obstacles, slope, box.");
    }

    @Test
    void fastIncludesWaitingForAgents() throws IOException {
        SimulatorSettings settings = settings("--fast");

        assertThat(settings.world().synchronous()).isTrue();
        assertThat(settings.speed()).isEqualTo(SimulationControl.AS_FAST_AS_POSSIBLE);
    }

    @Test
    void monitorsAreToldAndLoggedAsWanted() throws IOException {
        SimulatorSettings settings = settings("--log", "match.log", "--monitor-step", "0.02");

        assertThat(settings.monitors().log()).contains(Path.of("match.log"));
        assertThat(settings.monitors().stepSeconds()).isEqualTo(0.02);
        assertThat(settings().monitors().log()).isEmpty();
        assertThat(settings().monitors().stepSeconds()).isEqualTo(0.04);
    }

    @Test
    void monitorStepShorterThanACycleIsRefused() {
        assertThatThrownBy(() -> settings("--monitor-step", "0.01"))
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageContaining("--monitor-step 0.01 is not valid")
                .hasMessageContaining("The minimum is 0.02");
    }

    @Test
    void parametersAreChangedOneByOne() throws IOException {
        SimulatorSettings settings = settings("--set", "RuleHalfTime=60", "--set", "UseCharging=false");

        assertThat(settings.world().parameters().get(SoccerParameter.RULE_HALF_TIME))
                .isEqualTo(60);
        assertThat(settings.world().parameters().isOn(SoccerParameter.USE_CHARGING))
                .isFalse();
    }

    @Test
    void parametersCanStandInAFile() throws IOException {
        Path file = Files.writeString(
                folder.resolve("training.properties"),
                "# training\nRuleHalfTime=60\n\nUseCharging = false # no fouls\n");

        SimulatorSettings settings = settings("--parameters", file.toString(), "--set", "RuleHalfTime=90");

        assertThat(settings.world().parameters().get(SoccerParameter.RULE_HALF_TIME))
                .isEqualTo(90);
        assertThat(settings.world().parameters().isOn(SoccerParameter.USE_CHARGING))
                .isFalse();
    }

    @Test
    void mistakeInAFileOfParametersIsNamedWithItsLine() throws IOException {
        Path file = Files.writeString(folder.resolve("training.properties"), "RuleHalfTime=60\nUseChargin=false\n");

        assertThatThrownBy(() -> settings("--parameters", file.toString()))
                .isInstanceOf(UnreadableFileException.class)
                .hasMessageContaining("training.properties, line 2: ")
                .hasMessageContaining("Did you mean UseCharging?");
    }

    @ParameterizedTest
    @CsvSource({"UTF-8, '\uFEFF', '\n'", "UTF-16LE, '\uFEFF', '\r\n'", "windows-1252, '', '\r\n'", "UTF-8, '', '\r'"})
    void fileOfParametersOfAnyEditorIsRead(String encoding, String mark, String end) throws IOException {
        String text = mark + String.join(end, "RuleHalfTime=60", "# für alle", "BeamNoiseXY=0", "");
        Path file = Files.write(folder.resolve("training.properties"), text.getBytes(Charset.forName(encoding)));

        SimulatorSettings settings = settings("--parameters", file.toString());

        assertThat(settings.world().parameters().get(SoccerParameter.RULE_HALF_TIME))
                .isEqualTo(60);
        assertThat(settings.world().parameters().get(SoccerParameter.BEAM_NOISE_XY))
                .isZero();
    }

    @ParameterizedTest
    @CsvSource({
        "RuleHalfTime=60, 'line 3: \"RuleHalfTime\" is already set in line 1. Delete one of the two lines.'",
        "'BeamNoiseXY\u00A0= 0', 'line 3: In \"BeamNoiseXY\u00A0= 0\", character 12 is a no-break space (U+00A0)'",
        "'BeamNoiseXY = \u22121', 'line 3: In \"BeamNoiseXY = \u22121\", character 15 is the dash'",
        "'B\u0435amNoiseXY = 1', 'line 3: In \"B\u0435amNoiseXY = 1\", character 2 is the Cyrillic letter'",
        "BeamNoiseXY, 'line 3: Setting \"BeamNoiseXY\" has no value.'",
        "BeamNoiseXY = much, 'line 3: Value \"much\" of BeamNoiseXY is not a number.'"
    })
    void lineThatIsNotClearIsRefused(String line, String message) throws IOException {
        Path file = Files.writeString(folder.resolve("training.properties"), "RuleHalfTime=90\n\n" + line + "\n");

        assertThatThrownBy(() -> settings("--parameters", file.toString()))
                .isInstanceOf(UnreadableFileException.class)
                .hasMessageStartingWith(file + ", " + message);
    }

    @Test
    void fileOfParametersThatIsNoTextIsRefused() throws IOException {
        Path file = Files.write(folder.resolve("training.zip"), new byte[] {'P', 'K', 0, (byte) 0x81});

        assertThatThrownBy(() -> settings("--parameters", file.toString()))
                .isInstanceOf(UnreadableFileException.class)
                .hasMessageStartingWith("The file " + file + " cannot be read: line 1 ");
    }

    @Test
    void inThePlaceOfTheOriginalUnknownOptionsAreLeftOut() {
        Printed answer = Printed.by(
                "simulator",
                "--process-name",
                "rcssserver3d",
                "--init-script-prefix",
                "/usr/share/rcssserver3d",
                "--rvdraw-host=localhost",
                "--agnet-port",
                "3100",
                "--agent-port",
                "0",
                "--monitor-port",
                "0",
                "--fast",
                "--seconds",
                "0.1");

        assertThat(answer.exitCode()).isZero();
        assertThat(answer.err())
                .contains("Ignoring the unknown option --init-script-prefix.")
                .contains("Ignoring the unknown option --rvdraw-host=localhost")
                .contains("Ignoring the unknown option --agnet-port. Did you mean --agent-port?");
    }

    @Test
    void otherwiseUnknownOptionsAreRefused() {
        Printed answer = Printed.by("simulator", "--init-script-prefix", "/usr/share/rcssserver3d");

        assertThat(answer.exitCode()).isEqualTo(2);
        assertThat(answer.err()).contains("Unknown option --init-script-prefix.");
    }

    @Test
    void dashThatIsNoneIsNamed() {
        Printed answer = Printed.by("simulator", "\u2013\u2013sync");

        assertThat(answer.exitCode()).isEqualTo(2);
        assertThat(answer.err()).contains("character 1 is the dash \u2013 (U+2013): type -");
    }

    @Test
    void missingFileOfParametersIsTold() {
        assertThatThrownBy(() -> settings("--parameters", "nowhere.properties"))
                .isInstanceOf(UnreadableFileException.class)
                .hasMessageContaining("nowhere.properties does not exist");
    }

    @Test
    void eachParameterOfEachProfileIsExplainedByTheHelp() {
        String help = Printed.by("simulator", "--help").out();

        for (SoccerParameter parameter : SoccerParameter.values()) {
            assertThat(help).contains(parameter.simSparkName() + " ").contains(parameter.description());
        }
    }

    @Test
    void truthIsToldWhereItIsWanted() throws IOException {
        assertThat(settings().world().camera().ownPosition()).isFalse();
        assertThat(settings("--ground-truth").world().camera())
                .isEqualTo(CameraSettings.STANDARD.withTruth(true, true, true));
        assertThat(settings("--ground-truth", "mypos,ballpos").world().camera())
                .isEqualTo(CameraSettings.STANDARD.withTruth(true, false, true));
        assertThatThrownBy(() -> settings("--ground-truth=mood"))
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageContaining("Unknown ground truth \"mood\"");
    }

    @Test
    void patienceWithSilentAgentsCanBeSet() throws IOException {
        assertThat(settings().agents().silentSeconds()).isEqualTo(60);
        assertThat(settings("--drop-silent-after", "2.5").agents().silentSeconds())
                .isEqualTo(2.5);
        assertThat(settings("--drop-silent-after", "Infinity").agents().silentSeconds())
                .isInfinite();
        assertThatThrownBy(() -> settings("--drop-silent-after", "0"))
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageContaining("--drop-silent-after 0.0 is not valid");
    }

    @Test
    void unknownParameterIsAnsweredWithTheNearest() {
        assertThatThrownBy(() -> settings("--set", "RuleHalftime=60"))
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageContaining("Did you mean RuleHalfTime?");
    }

    @Test
    void commandLineIsStrongerThanTheScript() throws IOException {
        Path script =
                Files.writeString(folder.resolve("start.rb"), "$agentPort = 3500\naddSoccerVar('RuleHalfTime', 60)\n");

        SimulatorSettings settings =
                settings("--script-path", script.toString(), "--agent-port", "0", "--set", "RuleHalfTime=90");

        assertThat(settings.agents().port()).isZero();
        assertThat(settings.world().parameters().get(SoccerParameter.RULE_HALF_TIME))
                .isEqualTo(90);
    }

    @Test
    void scriptSetsWhatTheCommandLineLeavesOpen() throws IOException {
        Path script = Files.writeString(folder.resolve("start.rb"), "$agentPort = 3500\nBeamNoiseXY = 0\n");

        SimulatorSettings settings = settings("--script-path", script.toString());

        assertThat(settings.agents().port()).isEqualTo(3500);
        assertThat(settings.world().parameters().get(SoccerParameter.BEAM_NOISE_XY))
                .isZero();
    }

    @Test
    void portThatCannotBeIsRefused() {
        assertThatThrownBy(() -> settings("--agent-port", "70000"))
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageContaining("Port 70000 does not exist");
    }

    @Test
    void portInUseEndsWithOneClearMessage() throws IOException {
        try (ServerSocket other = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            String port = Integer.toString(other.getLocalPort());

            Printed answer = Printed.by("simulator", "--agent-port", port, "--monitor-port", "0");

            assertThat(answer.exitCode()).isEqualTo(1);
            assertThat(answer.err().lines()).singleElement().asString().contains(port, "--agent-port");
        }
    }

    @Test
    void simulationEndsAfterTheGivenTime() {
        Printed answer =
                Printed.by("simulator", "--agent-port", "0", "--monitor-port", "0", "--fast", "--seconds", "1");

        assertThat(answer.exitCode()).isZero();
        assertThat(answer.err()).contains("Agents can join on port ");
    }

    private static SimulatorSettings settings(String... options) throws IOException {
        SimulatorCommand command = new SimulatorCommand();
        new CommandLine(command).parseArgs(options);
        return command.settings(Console.silent());
    }
}
