package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.EnumSource.Mode;
import org.junit.jupiter.params.provider.MethodSource;
import org.robonewbie.app.studio.ProcessCompilerService;
import org.robonewbie.programs.process.JavaCommand;
import org.robonewbie.programs.process.Sandbox;
import org.robonewbie.studio.program.RunningProgram;

/** What programs do, by the way in which they are started. Whatever is not here is in {@code AttacksTest} and {@code HostileClassTest}. */
@Tag("slow")
@EnabledOnOs(OS.LINUX)
@Timeout(120)
class AttackDoorsTest {

    private static final String PROGRAM = """
            import org.robonewbie.agent.Agent;

            public class RaiseArms extends Agent {
                public static void main(String[] arguments) {
                    new RaiseArms().run(arguments);
                }

                static {
                    try {
                        %s
                    } catch (Exception e) {
                        System.out.println(e);
                    }
                }

                @Override
                protected void think() {}
            }
            """;

    private static final String GOOD = """
            import org.robonewbie.agent.Agent;
            import org.robonewbie.nao.Joint;

            public class RaiseArms extends Agent {
                public static void main(String[] arguments) {
                    new RaiseArms().run(arguments);
                }

                @Override
                protected void think() {
                    hold(Joint.LEFT_SHOULDER_PITCH, 60);
                    hold(Joint.RIGHT_SHOULDER_PITCH, 45);
                }

                private void hold(Joint joint, double degrees) {
                    nao.setJointSpeed(joint, 4 * (degrees - nao.getJointAngle(joint)));
                }
            }
            """;

    /** Leaves three processes in three ways. */
    private static final String LEAVES_PROCESSES = """
            for (String start : new String[] {"(setsid %1$s &)", "cd / && (setsid %1$s &)", "(%1$s &)"}) {
                new ProcessBuilder("sh", "-c", start).start().waitFor();
            }
            java.nio.file.Files.createFile(java.nio.file.Path.of("%2$s"));
            """;

    /** Loads code into the process that has started this one. The judge would have left a file before it ended. */
    private static final String ATTACHES = """
            System.setProperty("sun.tools.attach.attachTimeout", "300");
            java.nio.file.Path folder = java.nio.file.Files.createTempDirectory(java.nio.file.Path.of("%1$s"), "agent");
            java.nio.file.Path source = folder.resolve("Intruder.java");
            java.nio.file.Files.writeString(source, "public class Intruder { public static void agentmain(String a)"
                    + " throws Exception { java.nio.file.Files.createFile(java.nio.file.Path.of(a)); } }");
            javax.tools.ToolProvider.getSystemJavaCompiler().run(null, null, null, source.toString());
            java.util.jar.Manifest manifest = new java.util.jar.Manifest();
            manifest.getMainAttributes().putValue("Manifest-Version", "1.0");
            manifest.getMainAttributes().putValue("Agent-Class", "Intruder");
            java.nio.file.Path jar = folder.resolve("intruder.jar");
            try (java.util.jar.JarOutputStream out =
                    new java.util.jar.JarOutputStream(java.nio.file.Files.newOutputStream(jar), manifest)) {
                out.putNextEntry(new java.util.zip.ZipEntry("Intruder.class"));
                out.write(java.nio.file.Files.readAllBytes(folder.resolve("Intruder.class")));
            }
            String judge = Long.toString(ProcessHandle.current().parent().orElseThrow().pid());
            java.nio.file.Files.createFile(java.nio.file.Path.of("%1$s", "tried"));
            com.sun.tools.attach.VirtualMachine.attach(judge).loadAgent(jar.toString(), "%1$s/attached");
            """;

    @TempDir
    private Path folder;

    /** How a program is started. */
    @SuppressWarnings("ImmutableEnumChecker") // the lists are made by List.of
    enum Door {
        RUN("run", "FILE", "--headless", "--fast", "--seed", "1", "--seconds", "1"),
        GRADE("grade", "raise-arms", "FILE", "--seeds", "1", "--fence", "none"),
        GRADE_FENCED("grade", "raise-arms", "FILE", "--seeds", "1", "--fence", "required"),
        CLASS("grade", "raise-arms", "--class", "ALL", "--seeds", "1", "--fence", "none"),
        CLASS_FENCED("grade", "raise-arms", "--class", "ALL", "--seeds", "1", "--fence", "required"),
        COMPETITION(
                "competition",
                "exercise:raise-arms",
                "--rounds",
                "1",
                "--results",
                "OUT",
                "Red=TEAM",
                "--fence",
                "none"),
        COMPETITION_FENCED(
                "competition",
                "exercise:raise-arms",
                "--rounds",
                "1",
                "--results",
                "OUT",
                "Red=TEAM",
                "--fence",
                "required"),
        RECORD("record", "FILE", "--runs", "1", "--seconds", "1", "--out", "OUT"),
        ROOM();

        private final List<String> words;

        Door(String... words) {
            this.words = List.of(words);
        }

        List<String> words(Path all, String file) {
            return words.stream()
                    .map(word -> word.replace(
                                    "FILE", all.resolve("anna").resolve(file).toString())
                            .replace("ALL", all.toString())
                            .replace("TEAM", all.resolve("anna").toString())
                            .replace("OUT", all.resolveSibling("out").toString()))
                    .toList();
        }

        Printed open(Path all, String file) {
            skipWithoutFence();
            return Printed.by(words(all, file).toArray(String[]::new));
        }

        boolean isFenced() {
            return name().endsWith("FENCED");
        }

        boolean isClass() {
            return name().startsWith("CLASS");
        }

        void skipWithoutFence() {
            boolean required = System.getenv("ROBONEWBIE_REQUIRE_TOOLS") != null;
            assumeTrue(!isFenced() || required || Sandbox.find().isUp(), "no fence here");
        }
    }

    private Path all() {
        return folder.resolve("all");
    }

    private void handIn(String name, String text) throws IOException {
        Path file = all().resolve(name);
        Files.createDirectories(Objects.requireNonNull(file.getParent()));
        Files.writeString(file, text);
    }

    @ParameterizedTest
    @EnumSource(mode = Mode.EXCLUDE, names = "ROOM")
    void whatAProgramStartedOutlivesOnlyOnesOwnRun(Door door) throws Exception {
        String sleep = "sleep 96961." + ProcessHandle.current().pid() + door.ordinal();
        handIn("anna/RaiseArms.java", PROGRAM.formatted(LEAVES_PROCESSES.formatted(sleep, folder.resolve("began"))));

        Printed printed = door.open(all(), "RaiseArms.java");

        List<ProcessHandle> left = ProcessHandle.allProcesses()
                .filter(process -> process.info().commandLine().orElse("").contains(sleep))
                .toList();
        left.forEach(ProcessHandle::destroyForcibly);
        assertThat(left).as(printed.toString()).hasSize(door == Door.RUN ? 3 : 0);
        assertThat(folder.resolve("began").toFile().exists()).isEqualTo(!door.isFenced());
    }

    @Test
    void whatAProgramOfTheRoomStartedEndsWithIt() throws Exception {
        String sleep = "sleep 96961." + ProcessHandle.current().pid() + Door.ROOM.ordinal();
        handIn("anna/RaiseArms.java", PROGRAM.formatted(LEAVES_PROCESSES.formatted(sleep, folder.resolve("began"))));
        Path file = all().resolve("anna/RaiseArms.java");

        try (ServerSocket world = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
                ProcessCompilerService workshop = new ProcessCompilerService(all().resolve("anna"));
                RunningProgram program =
                        workshop.start(file, world.getLocalPort(), () -> {}).orElseThrow()) {
            world.setSoTimeout(60_000);
            world.accept().close();
            assertThat(program.output()).isNotNull();
        }

        assertThat(folder.resolve("began")).exists();
        assertThat(ProcessHandle.allProcesses()
                        .filter(process ->
                                process.info().commandLine().orElse("").contains(sleep)))
                .isEmpty();
    }

    @ParameterizedTest
    @EnumSource(
            mode = Mode.EXCLUDE,
            names = {"RUN", "RECORD", "ROOM"})
    void judgeLetsNoProgramIn(Door door) throws Exception {
        door.skipWithoutFence();
        handIn("anna/RaiseArms.java", PROGRAM.formatted(ATTACHES.formatted(folder)));

        String printed = printedByAProcess(JavaCommand.ofCommand(door.words(all(), "RaiseArms.java")));

        assertThat(folder.resolve("attached")).doesNotExist();
        assertThat(folder.resolve("tried").toFile().exists()).as(printed).isEqualTo(!door.isFenced());
        assertThat(printed).containsPattern("0\\.0 points|0\\.0 of 10|0 of 10").doesNotContain("PASSED");
    }

    /** Without the option the attack succeeds: so the test above would see it. */
    @Test
    void judgeThatAnybodyMayAttachToWouldLetThemIn() throws Exception {
        handIn("anna/RaiseArms.java", PROGRAM.formatted(ATTACHES.formatted(folder)));
        List<String> open = new ArrayList<>(JavaCommand.ofCommand(Door.GRADE.words(all(), "RaiseArms.java")));
        open.remove("-XX:+DisableAttachMechanism");

        String printed = printedByAProcess(open);

        assertThat(folder.resolve("attached")).as(printed).exists();
    }

    private String printedByAProcess(List<String> command) throws Exception {
        Process process = new ProcessBuilder(command)
                .directory(folder.toFile())
                .redirectErrorStream(true)
                .start();
        String printed = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        process.waitFor();
        return printed;
    }

    /** What is handed in as a program, made by a shell, and what is said of it where a person runs it and where a class does. */
    enum Input {
        PIPE("mkfifo F", "is not a regular file but a device or a pipe", "is not a regular file"),
        DEVICE("ln -s /dev/zero F", "is not a regular file but a device or a pipe", "is a link that leads out"),
        DEAD_LINK("ln -s /nowhere F", "does not exist", "is a broken link"),
        HUGE("truncate -s 3G F", "is larger than 16 MB", "more than 100 MB"),
        ANOTHERS_FILE("ln -s ../secret F", "The Java file has errors", "is a link that leads out"),
        SUM(
                "{ printf 'public class RaiseArms { int x = 1'; printf '+hashCode()%.0s' $(seq 30000); echo ';}'; } > F",
                "is nested too deeply", "nested"),
        DEEP(
                "{ printf 'public class RaiseArms { int x = '; printf '(%.0s' $(seq 20000); printf 1;"
                        + " printf ')%.0s' $(seq 20000); echo ';}'; } > F",
                "is nested too deeply", "nested");

        private final String shell;
        private final String sentence;
        private final String line;

        Input(String shell, String sentence, String line) {
            this.shell = shell;
            this.sentence = sentence;
            this.line = line;
        }

        void make(Path place) throws Exception {
            Files.createDirectories(place);
            Process made = new ProcessBuilder("bash", "-c", shell.replace("F", "RaiseArms.java"))
                    .directory(place.toFile())
                    .redirectErrorStream(true)
                    .start();
            assertThat(new String(made.getInputStream().readAllBytes(), StandardCharsets.UTF_8))
                    .isEmpty();
            made.waitFor();
        }
    }

    @ParameterizedTest
    @EnumSource
    void whoeverStartsWhatIsNoProgramReadsOneSentence(Input input) throws Exception {
        handIn("secret", "a password");
        input.make(all().resolve("anna"));

        for (Door door : List.of(Door.RUN, Door.GRADE, Door.GRADE_FENCED, Door.RECORD)) {
            if (door.isFenced() && input == Input.ANOTHERS_FILE) {
                continue; // there is no such file behind the fence
            }
            Printed printed = door.open(all(), "RaiseArms.java");

            boolean isJava = input.ordinal() >= Input.ANOTHERS_FILE.ordinal();
            assertThat(printed.exitCode()).as(printed.toString()).isEqualTo(isJava ? 1 : 2);
            assertThat(printed.err()).contains(input.sentence).doesNotContain("\tat ");
            assertThat(printed.err().lines().count()).isLessThan(8);
        }
    }

    @ParameterizedTest
    @EnumSource
    void roomSurvivesWhatIsNoProgram(Input input) throws Exception {
        handIn("secret", "a password");
        input.make(all().resolve("anna"));
        Path file = all().resolve("anna/RaiseArms.java");

        try (ProcessCompilerService workshop = new ProcessCompilerService(all().resolve("anna"))) {
            if (input == Input.ANOTHERS_FILE) {
                assertThat(workshop.start(file, 1, () -> {})).isEmpty();
            } else {
                assertThatThrownBy(() -> workshop.start(file, 1, () -> {})).hasMessageContaining(input.sentence);
            }
            if (input == Input.SUM || input == Input.DEEP) {
                String text = Files.readString(file);
                assertThat(workshop.check(file, text))
                        .singleElement()
                        .satisfies(remark -> assertThat(remark.text()).contains(input.sentence));
                assertThat(workshop.complete(file, text, text.length())).isEmpty();
            }
        }
    }

    @ParameterizedTest
    @EnumSource(names = {"CLASS", "CLASS_FENCED", "COMPETITION", "COMPETITION_FENCED"})
    void whatIsNoProgramCostsTheOthersNothing(Door door) throws Exception {
        handIn("secret", "a password");
        handIn("anna/RaiseArms.java", PROGRAM.formatted(""));
        List<String> words = new ArrayList<>(door.words(all(), ""));
        for (Input input : Input.values()) {
            input.make(all().resolve(input.name()));
            if (!door.isClass()) {
                words.add(input + "=" + all().resolve(input.name()));
            }
        }
        door.skipWithoutFence();

        Printed printed = Printed.by(words.toArray(String[]::new));

        String everything = printed.out()
                + printed.err()
                + (door.isClass() ? Files.readString(folder.resolve("all-grades/grades.csv")) : "");
        assertThat(everything).doesNotContain("a password").doesNotContain("\tat ");
        assertThat(Input.values()).allSatisfy(input -> assertThat(everything).contains(input.name(), input.line));
        assertThat(printed.exitCode()).as(printed.toString()).isEqualTo(door.isClass() ? 0 : 1);
        assertThat(printed.out()).containsPattern(door.isClass() ? "anna .* 0\\.0 points" : "Red .*played to the end");
    }

    /** What a program does to be judged better, or to the computer of its judge. */
    @SuppressWarnings("ImmutableEnumChecker") // a text
    enum Attack {
        ENDS_THE_PROCESS("System.exit(0);"),
        FORGES("""
                for (String answer : new String[] {"ready", "1 NONE\\t\\t", "2 NONE\\t\\t", "01-raise-arms PASSED: 10.0"}) {
                    System.out.println("\\u0001" + answer);
                    System.out.println(answer);
                }
                Runtime.getRuntime().halt(0);
                """),
        STARTS_A_CROWD("""
                for (int i = 0; i < 300; i++) { new ProcessBuilder("sleep", "%1$s").start(); }
                Thread.sleep(60_000);
                """),
        EATS_MEMORY("""
                java.util.List<byte[]> food = new java.util.ArrayList<>();
                while (true) { food.add(new byte[10_000_000]); }
                """),
        PRINTS_WITHOUT_END("""
                byte[] line = new byte[1 << 20];
                for (int i = 0; i < 100; i++) { System.out.write(line); }
                """),
        SNOOPS("""
                java.nio.file.Files.writeString(java.nio.file.Path.of("%2$s"), "mine");
                System.out.println(java.nio.file.Files.readString(java.nio.file.Path.of("%3$s")));
                """);

        private final String code;

        Attack(String code) {
            this.code = code;
        }
    }

    static Stream<Arguments> attacksThroughEachDoor() {
        return Stream.of(Attack.values())
                .flatMap(attack -> Stream.of(Door.values())
                        .filter(door ->
                                !List.of(Door.RUN, Door.RECORD, Door.ROOM).contains(door))
                        .map(door -> Arguments.of(attack, door)));
    }

    @ParameterizedTest
    @MethodSource("attacksThroughEachDoor")
    void attackCostsItsAuthorAndNothingElse(Attack attack, Door door) throws Exception {
        String seconds = "96962." + ProcessHandle.current().pid() + door.ordinal();
        Path written = folder.resolve("written");
        handIn("secret", "a password");
        handIn(
                "anna/RaiseArms.java",
                PROGRAM.formatted(attack.code.formatted(seconds, written, all().resolve("secret"))));
        handIn("zoe/RaiseArms.java", GOOD);
        List<String> words = new ArrayList<>(door.words(all(), "RaiseArms.java"));
        if (words.contains("competition")) {
            words.add("Zoe=" + all().resolve("zoe"));
        }
        door.skipWithoutFence();

        Printed printed = Printed.by(words.toArray(String[]::new));

        String said = printed.out().replaceAll(" +", " ");
        assertThat(said)
                .as(printed.toString())
                .containsPattern("anna raise-arms 0\\.0|Red 0 of 10| 0\\.0 of 10 points");
        assertThat(said).doesNotContain("01-raise-arms PASSED");
        if (words.contains("competition") || door.isClass()) {
            assertThat(said).containsPattern("zoe raise-arms 10\\.0|Zoe 10 of 10");
        }
        assertThat(ProcessHandle.allProcesses()
                        .filter(process ->
                                process.info().commandLine().orElse("").contains(seconds)))
                .isEmpty();
        if (door.isFenced()) {
            assertThat(written).doesNotExist();
            assertThat(printed.out() + printed.err()).doesNotContain("a password");
        }
    }

    /** In a class: {@code HostileClassTest}. A person's own grade is kept by nobody. */
    @ParameterizedTest
    @EnumSource(names = {"COMPETITION", "COMPETITION_FENCED"})
    void trialThatIsOverCannotBeForged(Door door) throws Exception {
        Path trials = folder.resolve("out/trials");
        String forges = """
                for (java.io.File trial : new java.io.File("%s").listFiles()) {
                    String text = java.nio.file.Files.readString(trial.toPath());
                    java.nio.file.Files.writeString(trial.toPath(), text.replace("Red", "Zed").replace("0", "9"));
                    System.out.println("forged " + trial);
                }
                """.formatted(trials);
        handIn("anna/RaiseArms.java", PROGRAM.formatted(""));
        handIn("zoe/RaiseArms.java", PROGRAM.formatted(forges));
        List<String> words = new ArrayList<>(door.words(all(), ""));
        words.addAll(List.of("Zed=" + all().resolve("zoe"), "--parallel", "1"));
        door.skipWithoutFence();

        Printed printed = Printed.by(words.toArray(String[]::new));

        try (Stream<Path> all = Files.list(trials)) {
            assertThat(all.filter(file -> file.toString().contains("Red")))
                    .singleElement()
                    .satisfies(
                            trial -> assertThat(trial).content().contains("Red").doesNotContain("Zed"));
        }
        assertThat(printed.out().replaceAll(" +", " ")).contains("Red 0 of 10");
        if (door == Door.COMPETITION) {
            assertThat(printed.out() + printed.err()).contains("was modified during the contest and has been restored");
        }
    }
}
