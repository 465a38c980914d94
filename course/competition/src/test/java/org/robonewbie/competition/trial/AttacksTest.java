package org.robonewbie.competition.trial;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.robonewbie.competition.contest.ChallengeContest;
import org.robonewbie.competition.contest.Conditions;
import org.robonewbie.competition.contest.ContestTrial;
import org.robonewbie.competition.contest.Contests;
import org.robonewbie.competition.contest.Ending;
import org.robonewbie.competition.contest.MatchContest;
import org.robonewbie.competition.contest.MatchKind;
import org.robonewbie.competition.contest.Role;
import org.robonewbie.competition.contest.TrialResult;
import org.robonewbie.competition.programs.EatsMemory;
import org.robonewbie.competition.programs.FillsMemory;
import org.robonewbie.competition.programs.Hangs;
import org.robonewbie.competition.programs.JoinsAsHonest;
import org.robonewbie.competition.programs.LeavesChildren;
import org.robonewbie.competition.programs.PrintsMuch;
import org.robonewbie.competition.programs.Snoops;
import org.robonewbie.competition.programs.Stands;
import org.robonewbie.competition.programs.StartsCrowd;
import org.robonewbie.competition.programs.TriesAllPorts;
import org.robonewbie.competition.team.TeamProgram;
import org.robonewbie.programs.process.Limits;
import org.robonewbie.programs.process.Sandbox;

/** What programs do to each other and to the organisers, with and without a fence: it fails, or it is told whose deed it was. */
@EnabledOnOs(OS.LINUX)
class AttacksTest {

    private static final Limits LIMITS = new Limits(256, 60, 20, 60, 120);

    @TempDir
    Path folder = Path.of("");

    /** Where programs run. */
    enum Ground {
        OPEN,
        FENCED;

        Sandbox fence() {
            Sandbox found = this == OPEN ? Sandbox.none("of this test") : Sandbox.find();
            boolean required = System.getenv("ROBONEWBIE_REQUIRE_TOOLS") != null;
            assumeTrue(this == OPEN || found.isUp() || required, () -> "no fence here: " + found.absence());
            return found;
        }
    }

    @BeforeEach
    void makeFolders() throws IOException {
        Files.createDirectories(folder.resolve("results/logs"));
    }

    @ParameterizedTest
    @EnumSource
    void whoBringsARobotInAnotherTeamsNameLosesItself(Ground ground) throws Exception {
        TrialResult result = match(ground, java(Stands.class), java(JoinsAsHonest.class));

        assertThat(result.of("Honest").ending()).isEqualTo(Ending.PLAYED);
        assertThat(result.of("Evil").ending()).isEqualTo(Ending.TOO_MANY_ROBOTS);
    }

    @ParameterizedTest
    @EnumSource
    void placeOfAnotherTeamCannotBeTaken(Ground ground) throws Exception {
        TrialResult result = match(ground, java(Stands.class), java(TriesAllPorts.class));

        assertThat(result.of("Honest").ending()).isEqualTo(Ending.PLAYED);
        assertThat(result.of("Evil").ending()).isEqualTo(ground == Ground.OPEN ? Ending.INTRUDED : Ending.PLAYED);
        if (ground == Ground.OPEN) {
            assertThat(Files.readString(folder.resolve("results/logs/matches-Honest-Evil-doors.txt")))
                    .contains("A connection to the port of Honest came from the program of Evil and was refused.");
        }
    }

    @Tag("slow")
    @ParameterizedTest
    @EnumSource
    void nothingThatAProgramStartedSurvivesItsTrial(Ground ground) throws Exception {
        String seconds = "78787." + ProcessHandle.current().pid();
        Path mark = Files.createDirectory(folder.resolve(seconds));

        TrialResult result = solo(ground, java(LeavesChildren.class, mark));

        assertThat(result.of("Evil").ending()).isEqualTo(Ending.PLAYED);
        assertThat(folder.resolve("results/logs/scoring-Evil.txt")).content().contains("sleep " + seconds);
        assertThat(ProcessHandle.allProcesses()
                        .filter(process ->
                                process.info().commandLine().orElse("").contains("sleep " + seconds)))
                .isEmpty();
    }

    @Tag("slow")
    @ParameterizedTest
    @EnumSource
    void crowdOfProcessesCostsTheTrial(Ground ground) throws Exception {
        TrialResult result = solo(ground, java(StartsCrowd.class));

        assertThat(result.of("Evil").ending()).isEqualTo(Ending.TOO_MANY_PROCESSES);
    }

    @Tag("slow")
    @ParameterizedTest
    @EnumSource
    void memoryOfAJavaProgramIsLimited(Ground ground) throws Exception {
        TrialResult result = solo(ground, java(EatsMemory.class));

        assertThat(result.of("Evil").ending()).isEqualTo(Ending.TOO_MUCH_MEMORY);
    }

    @Tag("slow")
    @ParameterizedTest
    @EnumSource
    void memoryOfAnyProgramIsLimited(Ground ground) throws Exception {
        String eats = "import time; food = []\nwhile True: food.append(bytearray(b'x') * 10_000_000); time.sleep(0.01)";
        TeamProgram python = new TeamProgram.OfCommand(
                List.of("python3", "-c", eats), Optional.empty(), Optional.empty(), false, "none");

        TrialResult result = solo(ground, python);

        assertThat(result.of("Evil").ending()).isEqualTo(Ending.TOO_MUCH_MEMORY);
    }

    @Tag("slow")
    @ParameterizedTest
    @EnumSource
    void outputIsLimited(Ground ground) throws Exception {
        TrialResult result = solo(ground, java(PrintsMuch.class));

        assertThat(result.of("Evil").ending()).isEqualTo(Ending.PLAYED);
        assertThat(folder.resolve("results/logs/scoring-Evil.txt"))
                .satisfies(log -> assertThat(Files.size(log)).isBetween(1_000_000L, 1_010_000L));
    }

    @ParameterizedTest
    @EnumSource(names = "FENCED")
    void programBehindTheFenceSeesItsOwnFilesAndNothingElse(Ground ground) throws Exception {
        Path teams = folder.resolve("teams");
        Path own = Files.createDirectories(teams.resolve("evil"));
        Path other = Files.createDirectories(teams.resolve("honest"));
        Path secret = Files.writeString(other.resolve("Secret.java"), "secret");
        Path within = Files.createDirectories(own.resolve("other"));
        Path inside = Files.writeString(within.resolve("Secret.java"), "secret");
        Files.writeString(own.resolve("own"), "mine");
        try (ServerSocket organisers = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            List<String> targets = List.of(
                    "read /etc/passwd",
                    "read /etc/shadow",
                    "read " + secret,
                    "read " + inside,
                    "read " + inside.toString().replace(own.toString(), "/team"),
                    "write " + secret,
                    "write " + folder.resolve("results/table.html"),
                    "write " + own.resolve("own"),
                    "write /usr/bin/robonewbie",
                    "port " + organisers.getLocalPort());
            Files.write(own.resolve("targets"), targets);
            TeamProgram honest = new TeamProgram.OfJava(
                    List.of(),
                    Map.of(Role.MAIN, Stands.class.getName()),
                    Optional.of(other),
                    Optional.empty(),
                    false,
                    "none");
            TeamProgram nested = new TeamProgram.OfJava(
                    List.of(),
                    Map.of(Role.MAIN, Stands.class.getName()),
                    Optional.of(within),
                    Optional.empty(),
                    false,
                    "");
            TeamProgram evil = new TeamProgram.OfJava(
                    List.of(own),
                    Map.of(Role.MAIN, Snoops.class.getName()),
                    Optional.of(own),
                    Optional.empty(),
                    false,
                    "none");

            TrialResult result = solo(ground, Map.of("Evil", evil, "Honest", honest, "Nested", nested), LIMITS);

            String log = Files.readString(folder.resolve("results/logs/scoring-Evil.txt"));
            assertThat(result.of("Evil").ending()).as(log).isEqualTo(Ending.PLAYED);
            assertThat(log)
                    .contains("could write at home", "own file: mine", "strangers: 0", "could not fill the disk");
            assertThat(targets).allSatisfy(target -> assertThat(log).contains("could not " + target + "\n"));
            assertThat(secret).hasContent("secret");
        }
    }

    @Tag("slow")
    @ParameterizedTest
    @EnumSource(names = "FENCED")
    void everyFileSystemBehindTheFenceHasALimit(Ground ground) throws Exception {
        Path other = Files.createDirectories(folder.resolve("teams/honest"));
        Path own = Files.createDirectories(folder.resolve("teams/evil"));
        List<String> folders = List.of(
                "/",
                "/dev",
                "/dev/shm",
                "/dev/mqueue",
                "/etc",
                "/home",
                "/run",
                "/run/robonewbie",
                "/team",
                "/usr",
                "/tmp",
                "/home/robot",
                folder.toString(),
                folder.resolve("results").toString(),
                folder.resolve("teams").toString(),
                other.toString());
        Files.write(own.resolve("folders"), folders);
        TeamProgram evil = new TeamProgram.OfJava(
                List.of(folder, own), roles(FillsMemory.class), Optional.of(own), Optional.empty(), false, "none");
        TeamProgram honest = new TeamProgram.OfJava(
                List.of(), roles(Stands.class), Optional.of(other), Optional.empty(), false, "none");

        TrialResult result = solo(ground, Map.of("Evil", evil, "Honest", honest), LIMITS);

        String log = Files.readString(folder.resolve("results/logs/scoring-Evil.txt"));
        assertThat(result.of("Evil").ending()).as(log).isEqualTo(Ending.PLAYED);
        int all = Integer.parseInt(log.replaceFirst("(?s).*all took (\\d+) MB.*", "$1"));
        assertThat(all).as(log).isBetween(250, 320);
        assertThat(log).contains("/tmp took ", "/dev/shm took ", "/run took 0 MB", "/ took 0 MB");
    }

    /** Python can call what Java 17 cannot. */
    @Tag("slow")
    @ParameterizedTest
    @EnumSource(names = "FENCED")
    void memoryThatBelongsToNoProcessIsNotToBeHad(Ground ground) throws Exception {
        assumeTrue(List.of("amd64", "aarch64").contains(System.getProperty("os.arch")), "no filter for this processor");
        String tries = """
                import ctypes, os
                libc = ctypes.CDLL(None, use_errno=True)
                libc.shmget.argtypes = [ctypes.c_int, ctypes.c_size_t, ctypes.c_int]
                print('shared', libc.shmget(0, 1 << 20, 0o1600))
                print('queue', libc.msgget(0, 0o1600))
                try: print('file', os.memfd_create('x'))
                except OSError as refused: print('file -1')
                """;
        Path script = Files.writeString(
                Files.createDirectories(folder.resolve("python")).resolve("tries.py"), tries);
        TeamProgram python = new TeamProgram.OfCommand(
                List.of("python3", script.toString()), Optional.empty(), Optional.empty(), false, "none");

        solo(ground, python);

        assertThat(folder.resolve("results/logs/scoring-Evil.txt"))
                .content()
                .contains("shared -1\n", "queue -1\n", "file -1\n");
    }

    @Tag("slow")
    @ParameterizedTest
    @EnumSource
    void memoryOfManyProcessesIsAddedUp(Ground ground) throws Exception {
        String eats = """
                import os, time
                for i in range(40):
                    if os.fork() == 0:
                        food = bytearray(b'x') * 40_000_000
                        time.sleep(60)
                        os._exit(0)
                time.sleep(60)
                """;
        TeamProgram python = new TeamProgram.OfCommand(
                List.of("python3", "-c", eats), Optional.empty(), Optional.empty(), false, "none");

        TrialResult result = solo(ground, python);

        assertThat(result.of("Evil").ending()).isEqualTo(Ending.TOO_MUCH_MEMORY);
    }

    @Tag("slow")
    @ParameterizedTest
    @EnumSource
    void clientForSimSparkPlaysUnchanged(Ground ground) throws Exception {
        Path script = Files.createDirectories(folder.resolve("python")).resolve("client.py");
        try (InputStream source = Objects.requireNonNull(Stands.class.getResourceAsStream("simspark_client.py"))) {
            Files.copy(source, script);
        }
        TeamProgram client = new TeamProgram.OfCommand(
                List.of("python3", script.toString(), "{host}", "{port}", "{team}", "{number}"),
                Optional.empty(),
                Optional.empty(),
                false,
                "none");

        TrialResult result = match(ground, client, java(Stands.class));

        String log = Files.readString(folder.resolve("results/logs/matches-Honest-Evil-Honest.txt"));
        assertThat(result.teams())
                .as(log)
                .allSatisfy(team -> assertThat(team.ending()).isEqualTo(Ending.PLAYED));
    }

    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"0.7, SILENT", "3, SILENT"})
    void endlessLoopIsNamedAsSuchWhateverThePatience(double patience, Ending ending) throws Exception {
        Limits limits = new Limits(256, 60, patience, 60, 120);

        assertThat(match(Ground.OPEN, java(Stands.class), java(Hangs.class), limits)
                        .of("Evil")
                        .ending())
                .isEqualTo(ending);
        assertThat(solo(Ground.OPEN, Map.of("Evil", java(Hangs.class)), limits)
                        .of("Evil")
                        .ending())
                .isEqualTo(ending);
    }

    private TrialResult match(Ground ground, TeamProgram honest, TeamProgram evil) throws Exception {
        return match(ground, honest, evil, LIMITS);
    }

    private TrialResult match(Ground ground, TeamProgram honest, TeamProgram evil, Limits limits) throws Exception {
        MatchContest contest = new MatchContest(MatchKind.MATCHES, 1, 4, Conditions.of(1));
        ContestTrial trial = contest.trials(List.of("Honest", "Evil"), id -> Optional.empty())
                .get(0);
        Map<String, TeamProgram> programs = new LinkedHashMap<>(Map.of("Honest", honest, "Evil", evil));
        return new TrialRunner(contest, programs, limits, ground.fence(), Spectators.NOBODY).run(trial, files());
    }

    private TrialResult solo(Ground ground, TeamProgram evil) throws Exception {
        return solo(ground, Map.of("Evil", evil), LIMITS);
    }

    private TrialResult solo(Ground ground, Map<String, TeamProgram> programs, Limits limits) throws Exception {
        ChallengeContest contest = (ChallengeContest) Contests.scoring(Conditions.of(1), 4);
        ContestTrial trial =
                contest.trials(List.of("Evil"), id -> Optional.empty()).get(0);
        return new ChallengePlayer(contest.challenge(), programs, limits, ground.fence(), Spectators.NOBODY)
                .run(trial, files());
    }

    private TrialFiles files() {
        Path results = folder.resolve("results");
        return new TrialFiles(Optional.empty(), results.resolve("logs"), results.resolve("work"));
    }

    private static Map<Role, String> roles(Class<?> main) {
        Map<Role, String> roles = new LinkedHashMap<>();
        Stream.of(Role.values()).forEach(role -> roles.put(role, main.getName()));
        return roles;
    }

    private static TeamProgram java(Class<?> main, Path... classPath) {
        return new TeamProgram.OfJava(
                List.of(classPath), roles(main), Optional.empty(), Optional.empty(), false, "none");
    }
}
