package org.robonewbie.agent;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.agent.running.WantedSimulator;
import org.robonewbie.agent.running.WantedSimulator.Kind;
import org.robonewbie.nao.geometry.Pose2d;

class OptionsTest {

    @TempDir
    private Path folder;

    @Test
    void readsAllKindsOfValues() {
        Options options = read("--number", "7", "--pose", "-0.5,0.4,-40", "--seed=12", "--fast", "--seconds", "1.5");

        assertThat(options.number()).isEqualTo(7);
        assertThat(options.pose()).contains(new Pose2d(-0.5, 0.4, -40));
        assertThat(options.seed()).hasValue(12);
        assertThat(options.isFast()).isTrue();
        assertThat(options.seconds()).hasValue(1.5);
        assertThat(options.isHeadless()).isFalse();
    }

    @Test
    void prefersTheCommandLineToTheFileAndTheFileToTheEnvironment() throws IOException {
        Files.writeString(file(), "team=File\nnumber=5\n");
        Map<String, String> environment =
                Map.of("ROBONEWBIE_TEAM", "Air", "ROBONEWBIE_NUMBER", "3", "ROBONEWBIE_TYPE", "2");

        Options options = Options.none()
                .withTeam("Program")
                .withNumber(5)
                .withPose(-1, 0, 0)
                .overriddenBy(List.of("--team", "Line"), file().toString(), environment);

        assertThat(options.team()).isEqualTo("Line");
        assertThat(options.number()).isEqualTo(5);
        assertThat(options.type()).isEqualTo(2);
        assertThat(options.pose()).contains(new Pose2d(-1, 0, 0));
    }

    @Test
    void leavesTheProgramsPlaceToItsUsualNumber() {
        Options striker = Options.none().withPose(-0.5, 0.4, -40);

        assertThat(with(striker).pose()).isPresent();
        assertThat(with(striker, "--number", "1").pose()).isPresent();
        assertThat(with(striker.withNumber(9), "--number", "9").pose()).isPresent();
        assertThat(with(striker, "--number", "2").pose()).isEmpty();
        assertThat(with(striker.withNumber(9), "--number", "1").pose()).isEmpty();
        assertThat(with(striker.withNumber(9), "--number", "0").pose()).isPresent();
    }

    @Test
    void takesThePlaceThatTheUserNamesForAnyNumber() {
        Options striker = Options.none().withPose(-0.5, 0.4, -40);

        assertThat(with(striker, "--number", "7", "--pose", "-3,0,0").pose()).contains(new Pose2d(-3, 0, 0));
        assertThat(with(striker, "--number", "7", "--pose", "-0.5,0.4,-40").pose())
                .isPresent();
    }

    @Test
    void keepsOtherArgumentsForTheAgent() {
        Options options = read("dance.txt", "--headless", "-5");

        assertThat(options.isHeadless()).isTrue();
        assertThat(options.arguments()).containsExactly("dance.txt", "-5");
    }

    @Test
    void guessesWhatAMisspeltOptionMeans() {
        assertThatThrownBy(() -> read("--hots", "here"))
                .isInstanceOf(StartUpException.class)
                .hasMessage("The option \"hots\" on the command line is unknown. Did you mean --host?");
    }

    @Test
    void saysWhatAWrongValueShouldHaveBeen() {
        assertThatThrownBy(() -> read("--number", "12"))
                .hasMessage("--number needs a whole number from 0 to 11, not \"12\" (on the command line).");
        assertThatThrownBy(() -> read("--pose", "1,2"))
                .hasMessage("--pose needs three numbers X,Y,DEGREES such as -0.5,0.4,-40, not \"1,2\" (on the"
                        + " command line).");
        assertThatThrownBy(() -> read("--seed")).hasMessage("--seed needs a value; see --help.");
    }

    @ParameterizedTest
    @CsvSource({"UTF-8, '\uFEFF'", "UTF-16LE, '\uFEFF'", "windows-1252, ''"})
    void propertiesOfAnyEditorAreRead(String encoding, String mark) throws IOException {
        Files.write(file(), (mark + "team=Red\r\n# für später\r\n").getBytes(Charset.forName(encoding)));

        assertThat(read().team()).isEqualTo("Red");
    }

    @ParameterizedTest
    @CsvSource({
        "report=C:\\new.json, a single backslash would be lost",
        "team\u00A0=Red, character 5 is a no-break space (U+00A0)",
        "t\u0435am=Red, character 2 is the Cyrillic letter"
    })
    void lineOfThePropertiesThatIsNotClearIsRefused(String line, String problem) throws IOException {
        Files.writeString(file(), "number=3\n" + line + "\n");

        assertThatThrownBy(() -> read())
                .isInstanceOf(StartUpException.class)
                .hasMessageStartingWith(file() + ", line 2: In \"")
                .hasMessageContaining(problem);
    }

    @Test
    void optionThatLooksRightIsExplained() {
        assertThatThrownBy(() -> read("--te\u0430m", "Red"))
                .hasMessage(
                        "The option \"te\u0430m\" on the command line is unknown. It looks like --team, but character 3 is the"
                                + " Cyrillic letter \u0430 (U+0430): type a.");
    }

    @Test
    void namesTheFileInWhichAMistakeIs() throws IOException {
        Files.writeString(file(), "seconds=soon\n");

        assertThatThrownBy(() -> read())
                .hasMessage("--seconds needs a number above 0, not \"soon\" (in robonewbie.properties).");
    }

    @Test
    void startsAnOwnSimulatorForASeedAndJoinsANamedHost() {
        assertThat(SimulatorChoice.of(read("--seed", "1"), 1, "Ada").kind()).isEqualTo(Kind.OWN);
        assertThat(SimulatorChoice.of(read("--fast"), 1, "Ada").kind()).isEqualTo(Kind.OWN);
        assertThat(SimulatorChoice.of(read("--host", "there"), 1, "Ada").kind()).isEqualTo(Kind.SERVER);
        assertThat(SimulatorChoice.of(read("--host", "there"), 1, "Ada").host()).isEqualTo("there");
        assertThat(SimulatorChoice.of(read("--seconds", "3"), 1, "Ada").kind()).isEqualTo(Kind.ANY);
        assertThat(SimulatorChoice.of(read(), 1, "Ada").port()).isEqualTo(3100);
    }

    @Test
    void prefersASeedOfTheCommandLineToAHostOfTheFile() throws IOException {
        Files.writeString(file(), "host=there\n");

        Options options = read("--seed", "1");

        assertThat(SimulatorChoice.of(options, 1, "Ada").kind()).isEqualTo(Kind.OWN);
    }

    @Test
    void sceneNeedsASimulatorOfItsOwnAndIsHandedToIt() {
        WantedSimulator wanted = SimulatorChoice.of(read("--scene", "slope"), 1, "Ada");

        assertThat(wanted.kind()).isEqualTo(Kind.OWN);
        assertThat(wanted.own().scene()).contains("slope");
        assertThat(SimulatorChoice.of(read("--seed", "1"), 1, "Ada").own().scene())
                .isEmpty();
    }

    @Test
    void refusesAHostTogetherWithASeed() {
        assertThatThrownBy(() -> read("--seed", "1", "--host", "there"))
                .hasMessage(
                        "--seed needs an embedded simulator, but --host there selects a server: remove one of the two"
                                + " options.");
    }

    @Test
    void otherArgumentsAreRefusedUnlessTheProgramAcceptsThem() {
        Options surplus = Options.of("--seconds", "5", "foo");

        assertThatThrownBy(surplus::checkWords)
                .isInstanceOf(StartUpException.class)
                .hasMessageStartingWith("\"foo\" is not an option. Options begin with --");
        assertThatCode(() -> Options.none().withWords().overriddenBy("foo").checkWords())
                .doesNotThrowAnyException();
    }

    @Test
    void placeFarOutsideOfEveryPitchIsRefused() {
        assertThatThrownBy(() -> Options.of("--pose", "50,2,0").pose())
                .isInstanceOf(StartUpException.class)
                .hasMessageContaining("--pose 50,2,0 is outside every pitch");
    }

    @Test
    void explainsEachOptionInTheHelp() {
        for (Option option : Option.values()) {
            assertThat(Options.help()).contains(option.argument());
        }
    }

    private Options read(String... args) {
        return with(Options.none(), args);
    }

    private Options with(Options program, String... args) {
        return program.overriddenBy(List.of(args), file().toString(), Map.of());
    }

    private Path file() {
        return folder.resolve("robonewbie.properties");
    }

    @Test
    void eachNumberHasAPlaceOfItsOwnInTheOwnHalf() {
        List<Pose2d> places = IntStream.rangeClosed(1, 11)
                .mapToObj(number -> Options.none().pose(number))
                .toList();

        assertThat(places).allSatisfy(one -> {
            assertThat(one.x()).isNegative();
            assertThat(places)
                    .filteredOn(other -> one.translation().distanceTo(other.translation()) < 0.5)
                    .containsExactly(one);
        });
    }
}
