package org.robonewbie.competition.team;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.competition.contest.Ending;
import org.robonewbie.competition.contest.Role;
import org.robonewbie.competition.contest.StartPlace;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.programs.process.Sandbox;

class TeamProgramsTest {

    private static final String AGENT = """
        import org.robonewbie.agent.Agent;
        public class %1$s extends Agent {
            public static void main(String[] args) { new %1$s().run(args); }
        }
        """;

    @TempDir
    Path folder = Path.of("");

    @Test
    void folderOfJavaFilesIsCompiledAndItsOnlyMainFound() throws IOException {
        write("red/Striker.java", AGENT.formatted("Striker"));
        write("red/Tools.java", "class Tools {}");

        TeamProgram program = find("Red=red");

        assertThat(program).isInstanceOf(TeamProgram.OfJava.class);
        assertThat(((TeamProgram.OfJava) program).mainClasses()).containsEntry(Role.MAIN, "Striker");
    }

    /** A team that plays from the folder in which it has its program would else copy results that are being written. */
    @Tag("slow")
    @Test
    void resultsOfContestsInTheFolderOfATeamAreNoPartOfIt() throws IOException {
        write("red/Striker.java", AGENT.formatted("Striker"));
        TeamProgram before = find("Red=red");
        write("red/results/work/walk-Red/Striker.java", "this does not compile");

        TeamProgram during = find("Red=red");

        assertThat(during).isInstanceOf(TeamProgram.OfJava.class);
        assertThat(during.fingerprint()).isEqualTo(before.fingerprint());
    }

    @Tag("slow")
    @Test
    void singleFileBringsItsFolderAndNothingBelow() throws IOException {
        write("red/Striker.java", AGENT.formatted("Striker"));
        write("red/Tools.java", "class Tools {}");
        write("red/old/Striker.java", AGENT.formatted("Striker"));
        write("red/src/Other.java", "this does not compile");

        TeamProgram program = find("Red=red/Striker.java");

        assertThat(program).isInstanceOf(TeamProgram.OfJava.class);
        assertThat(((TeamProgram.OfJava) program).mainClasses()).containsEntry(Role.MAIN, "Striker");
    }

    @Tag("slow")
    @Test
    void mavenProjectIsCompiledWithoutMaven() throws IOException {
        write("red/pom.xml", "<project/>");
        write("red/src/main/java/my/team/Striker.java", "package my.team;\n" + AGENT.formatted("Striker"));
        write("red/src/test/java/StrikerTest.java", "this does not compile");

        TeamProgram program = find("Red=red");

        assertThat(((TeamProgram.OfJava) program).mainClasses()).containsEntry(Role.MAIN, "my.team.Striker");
    }

    @Tag("slow")
    @Test
    void rolesMayHaveClassesOfTheirOwn() throws IOException {
        write("red/Striker.java", AGENT.formatted("Striker"));
        write("red/Keeper.java", AGENT.formatted("Keeper"));

        TeamProgram program = find("Red=red", "Red.main=Striker", "Red.goalkeeper=Keeper");

        assertThat(((TeamProgram.OfJava) program).mainClasses())
                .containsEntry(Role.ATTACKER, "Striker")
                .containsEntry(Role.GOALKEEPER, "Keeper");
        assertThatThrownBy(() -> find("Red=red"))
                .hasMessage("Team Red has several classes with a main method: Keeper, Striker. Choose one: Red.main ="
                        + " Keeper");
        assertThatThrownBy(() -> find("Red=red", "Red.main=Star"))
                .hasMessage("Team Red has no class Star with a main method. It has: Keeper, Striker.");
    }

    /** What is refused in a team's folder, made by a shell in it. */
    @DisabledOnOs(OS.WINDOWS)
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            mkfifo data                            | red/data is not a regular file but a device, a pipe
            ln -s /dev/zero data.bin               | red/data.bin is a link that leads out of the folder
            ln -s nowhere notes.txt                | red/notes.txt is a broken link
            ln -s ../blue/Blue.java Blue.java      | red/Blue.java is a link that leads out of the folder
            ln -s ../blue lib                      | red/lib is a link that leads out of the folder
            ln -s .. up                            | red/up is a link that leads out of the folder
            ln -s self self                        | red/self is a circular link
            ln -s ../blue/Blue.java Tools.jar      | red/Tools.jar is a link that leads out of the folder
            truncate -s 3G data.bin                | red contains more than 100 MB
            rm -r ../red && ln -s blue ../red      | red is a link. Replace it with its target
            """)
    void badFolderCostsItsTeamAndNamesTheFile(String command, String complaint) throws Exception {
        write("blue/Blue.java", AGENT.formatted("Blue"));
        write("red/Striker.java", AGENT.formatted("Striker"));
        shell(command);

        TeamProgram program = find("Red=red");

        assertThat(program).isInstanceOf(TeamProgram.Broken.class);
        assertThat(((TeamProgram.Broken) program).ending()).isEqualTo(Ending.REFUSED);
        assertThat(((TeamProgram.Broken) program).complaint()).contains(complaint);
    }

    @DisabledOnOs(OS.WINDOWS)
    @ParameterizedTest
    @ValueSource(strings = {"Red=red/Thief.java", "Red=red/thief.jar", "Red=python3 red/thief.py"})
    void fileOfAnotherTeamIsNoProgram(String entry) throws Exception {
        write("blue/Blue.java", AGENT.formatted("Blue"));
        write("red/README", "");
        shell(
                "for end in java jar py; do ln -s ../blue/Blue.java Thief.$end; ln -s ../blue/Blue.java thief.$end; done");

        TeamProgram program = find(entry);

        assertThat(program).isInstanceOf(TeamProgram.Broken.class);
        assertThat(((TeamProgram.Broken) program).complaint()).contains("link");
    }

    @Tag("slow")
    @Test
    void fingerprintCoversEachFolderThatIsCompiled() throws IOException {
        write("red/src/main/competition.lock", "");
        write("red/src/main/Striker.java", AGENT.formatted("Striker"));
        String before = find("Red=red").fingerprint();

        write("red/src/main/Striker.java", AGENT.formatted("Striker") + "class Other {}");

        assertThat(find("Red=red").fingerprint()).isNotEqualTo(before);
    }

    @Tag("slow")
    @Test
    void folderOfAnotherTeamWithinOnesOwnDoesNotBelongToIt() throws IOException {
        write("red/Striker.java", AGENT.formatted("Striker"));
        write("red/blue/Blue.java", "package blue;\n" + AGENT.formatted("Blue"));

        TeamProgram program = find("Red=red", "Blue=red/blue");

        assertThat(program.folder().orElseThrow().resolve("Striker.java")).exists();
        assertThat(program.folder().orElseThrow().resolve("blue")).doesNotExist();
    }

    /** Compilers end with a stack overflow here, or with a message. */
    @Tag("slow")
    @ParameterizedTest
    @EnumSource
    void sourcesThatOvertaxTheCompilerCostTheirTeam(Place place) throws IOException {
        write("red/Striker.java", AGENT.formatted("Striker"));
        write("red/Deep.java", "class Deep { int x = " + "(".repeat(20_000) + "1" + ")".repeat(20_000) + "; }");

        TeamProgram program = find(place.fence(), "Red=red");

        assertThat(program).isInstanceOf(TeamProgram.Broken.class);
        assertThat(((TeamProgram.Broken) program).ending()).isEqualTo(Ending.NOT_COMPILED);
        assertThat(((TeamProgram.Broken) program).complaint()).isNotBlank();
    }

    @Tag("slow")
    @ParameterizedTest
    @EnumSource
    void compilerNamesTheFileThatTheTeamKnows(Place place) throws IOException {
        write("red/Striker.java", "class Striker { int x = ; }");

        TeamProgram program = find(place.fence(), "Red=red");

        assertThat(((TeamProgram.Broken) program).complaint())
                .contains(folder.resolve("red/Striker.java") + ":1: error")
                .doesNotContain("classes");
    }

    @Tag("slow")
    @ParameterizedTest
    @EnumSource
    void compilerBehindTheFenceMakesTheSameClasses(Place place) throws IOException {
        write("red/src/main/java/my/team/Striker.java", "package my.team;\n" + AGENT.formatted("Striker"));

        TeamProgram program = find(place.fence(), "Red=red");

        assertThat(((TeamProgram.OfJava) program).mainClasses()).containsEntry(Role.MAIN, "my.team.Striker");
        assertThat(folder.resolve("classes/Red/classes/my/team/Striker.class")).exists();
    }

    /** Where the compiler runs. */
    enum Place {
        OPEN,
        FENCED;

        Sandbox fence() {
            Sandbox found = this == OPEN ? Sandbox.none("of this test") : Sandbox.find();
            boolean required = System.getenv("ROBONEWBIE_REQUIRE_TOOLS") != null;
            assumeTrue(this == OPEN || found.isUp() || required, () -> "no fence here: " + found.absence());
            return found;
        }
    }

    private void shell(String command) throws Exception {
        Process process = new ProcessBuilder("sh", "-c", command)
                .directory(folder.resolve("red").toFile())
                .redirectErrorStream(true)
                .start();
        assertThat(new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8))
                .isEmpty();
        assertThat(process.waitFor()).isZero();
    }

    @Tag("slow")
    @Test
    void mistakesOfTheTeamAreKeptForItsLog() throws IOException {
        write("red/Striker.java", "class Striker { int x = ; }");

        TeamProgram program = find("Red=red");

        assertThat(program).isInstanceOf(TeamProgram.Broken.class);
        assertThat(((TeamProgram.Broken) program).complaint()).contains("Striker.java");
    }

    @Tag("slow")
    @Test
    void changedProgramIsNoticed() throws IOException {
        write("red/Striker.java", AGENT.formatted("Striker"));
        String before = find("Red=red").fingerprint();

        assertThat(find("Red=red").fingerprint()).isEqualTo(before);
        write("red/Striker.java", AGENT.formatted("Striker") + "// better now");
        assertThat(find("Red=red").fingerprint()).isNotEqualTo(before);
    }

    @Test
    void commandGetsItsPlacesFilledIn() throws IOException {
        write("green.py", "");
        Start start = new Start(3500, "Green", Role.MAIN, List.of(new StartPlace(4, -1, 0.5, 90)));

        TeamProgram.OfCommand open = (TeamProgram.OfCommand) find("Green=python3 green.py {port} {team} {pose}");
        TeamProgram.OfCommand plain = (TeamProgram.OfCommand) find("Green=python3 green.py");

        assertThat(start.fill(open.words(), false))
                .containsExactly("python3", folder.resolve("green.py").toString(), "3500", "Green", "-1,0.5,90");
        assertThat(start.fill(plain.words(), false))
                .endsWith(
                        "--host",
                        "127.0.0.1",
                        "--port",
                        "3500",
                        "--team",
                        "Green",
                        "--number",
                        "4",
                        "--pose",
                        "-1,0.5,90");
    }

    @Tag("slow")
    @Test
    void pathOfWindowsIsUnderstood() throws IOException {
        write("teams/red/Striker.java", AGENT.formatted("Striker"));

        assertThat(((TeamProgram.OfJava) find("Red=teams\\red")).mainClasses()).containsEntry(Role.MAIN, "Striker");
    }

    @ParameterizedTest
    @ValueSource(strings = {"Red teams/red", "Red: teams/red", "teams/red # our best", "teams/red/Striker.java x"})
    void commandThatCannotBeStartedIsRefusedBeforeTheContest(String line) throws IOException {
        write("teams/red/Striker.java", AGENT.formatted("Striker"));

        assertThatThrownBy(() -> find(line))
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageContaining("is not an executable program")
                .hasMessageContaining("NAME = PROGRAM");
    }

    @Test
    void commandMayBeInTheFolderOfTheTeam() throws IOException {
        write("green/run.sh", "#!/bin/sh");
        assertThat(folder.resolve("green/run.sh").toFile().setExecutable(true)).isTrue();

        assertThat(find("Green=./run.sh {port}", "Green.folder=green")).isInstanceOf(TeamProgram.OfCommand.class);
    }

    @Tag("slow")
    @ParameterizedTest
    @ValueSource(strings = {"UTF-8", "UTF-16LE", "windows-1252"})
    void programsOfAnyEditorCompile(String encoding) throws IOException {
        String mark = encoding.equals("windows-1252") ? "" : "\uFEFF";
        write("red/Striker.java", AGENT.formatted("Striker"));
        Files.write(
                folder.resolve("red/Größe.java"),
                (mark + "class Größe { int äöü; }\r\n").getBytes(Charset.forName(encoding)));

        assertThat(find("Red=red")).isInstanceOf(TeamProgram.OfJava.class);
    }

    @Tag("slow")
    @Test
    void fileThatIsNoTextIsACompilersComplaint() throws IOException {
        write("red/Striker.java", AGENT.formatted("Striker"));
        Files.write(folder.resolve("red/Tools.java"), new byte[] {'c', 'l', 0, 0, 0});

        TeamProgram program = find("Red=red");

        assertThat(((TeamProgram.Broken) program).complaint())
                .contains("Tools.java cannot be read: line 1 contains a zero byte");
    }

    @Test
    void whatIsNothingIsToldSo() throws IOException {
        Files.createDirectories(folder.resolve("empty"));

        assertThatThrownBy(() -> find("Red=rde"))
                .hasMessageStartingWith(
                        "Team Red: there is no folder, jar, Java file, example or command \"rde\" (in the folder ");
        assertThatThrownBy(() -> find("Red=empty")).hasMessageEndingWith("contains no Java files.");
    }

    private TeamProgram find(String... lines) throws IOException {
        return find(Sandbox.none("of this test"), lines);
    }

    private TeamProgram find(Sandbox fence, String... lines) throws IOException {
        List<TeamEntry> teams = TeamList.parse(List.of(lines));
        TeamPrograms finder = new TeamPrograms(folder, folder.resolve("classes"), Map.of(), fence);
        List<Path> foreign = new ArrayList<>(finder.folders(teams));
        foreign.add(folder.resolve("red/results"));
        return finder.find(teams.get(0), foreign);
    }

    private void write(String name, String text) throws IOException {
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        Files.writeString(file, text);
    }
}
