package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.jar.Attributes;
import java.util.jar.JarFile;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.nao.file.TemporaryFolder;

/** Starts the real launcher with a Java and a Maven that only say what they were asked. */
@DisabledOnOs(OS.WINDOWS)
@Timeout(120)
@Tag("slow")
class LauncherTest {

    private static final String BUILD = "app/src/launcher/java/Build.java";

    private static final List<String> TOOLS = List.of(
            "sh",
            "dirname",
            "basename",
            "readlink",
            "sed",
            "head",
            "find",
            "mkdir",
            "cat",
            "rm",
            "sleep",
            "touch",
            "cp",
            "mv",
            "grep",
            "tail",
            "locale",
            "od",
            "tr",
            "fold",
            "mktemp");

    @TempDir
    Path temporaryFolder = Path.of("");

    private Path home = Path.of("");
    private Path jdk = Path.of("");
    private Path tools = Path.of("");

    private record Begun(Process process, Path errors) {}

    private record Ended(int exitCode, String out, String err) {}

    @BeforeEach
    void makeSmallProject() throws IOException {
        home = Files.createDirectories(temporaryFolder.resolve("Robo Newbie (1)"));
        jdk = temporaryFolder.resolve("jdk");
        tools = Files.createDirectories(temporaryFolder.resolve("tools"));
        for (String tool : TOOLS) {
            Files.createSymbolicLink(tools.resolve(tool), find(tool));
        }
        Files.copy(Project.ROOT.resolve("robonewbie"), home.resolve("robonewbie"));
        Files.createDirectories(home.resolve(BUILD).getParent());
        Files.copy(Project.ROOT.resolve(BUILD), home.resolve(BUILD));
        write(home.resolve("pom.xml"), "<project/>");
        write(home.resolve("app/pom.xml"), "<project/>");
        write(home.resolve("app/src/main/java/Main.java"), "class Main {}");
        maven("mkdir -p app/target; echo jar >app/target/robonewbie.jar; echo '[INFO] BUILD SUCCESS'");
        java(jdk, "17.0.15");
    }

    @Test
    void firstStartBuildsAndRuns() throws Exception {
        Ended start = start("run", "my agent.java", "--seed", "3");

        assertThat(start.exitCode()).isEqualTo(7);
        assertThat(start.err()).contains("Building RoboNewbie for the first time", "RoboNewbie is built.");
        assertThat(start.out()).contains("<-jar>", "<run>", "<my agent.java>", "<--seed>", "<3>");
    }

    @Test
    void secondStartDoesNotBuild() throws Exception {
        start("--help");

        Ended second = start("--help");

        assertThat(second.err()).isEmpty();
        assertThat(builds()).isEqualTo(1);
    }

    @Test
    void programThatLiesReadyIsRunWithoutBuilding() throws Exception {
        String release = "maven/org/robonewbie/robonewbie/2.0.0/robonewbie-2.0.0.jar";
        write(home.resolve(release), "jar");

        Ended start = start("--help");

        assertThat(start.err()).isEmpty();
        assertThat(start.out()).contains(release);
        assertThat(temporaryFolder.resolve("builds.txt")).doesNotExist();
    }

    @Test
    void changedSourceIsBuilt() throws Exception {
        start("--help");
        changeSource();

        Ended second = start("--help");

        assertThat(second.err()).contains("Sources have changed");
        assertThat(builds()).isEqualTo(2);
    }

    @Test
    void userStaysInTheOwnFolder() throws Exception {
        Ended start = start("--help");

        assertThat(start.out()).contains("in " + temporaryFolder.toRealPath());
    }

    @Test
    void linkToTheLauncherWorks() throws Exception {
        Path link = Files.createSymbolicLink(temporaryFolder.resolve("rn"), home.resolve("robonewbie"));

        Ended start = end(begin(link, "--help"));

        assertThat(start.exitCode()).isEqualTo(7);
    }

    @Test
    void mistakeInASourceIsShownInFull() throws Exception {
        maven("echo '[INFO] Scanning'; echo '[ERROR] COMPILATION ERROR :'; echo '[ERROR] Main.java:[3,1] no'; exit 1");

        Ended start = start("--help");

        assertThat(start.exitCode()).isEqualTo(1);
        assertThat(start.out()).isEmpty();
        assertThat(start.err())
                .contains("The build of RoboNewbie failed:", "Main.java:[3,1] no", "What to do: correct the Java file")
                .doesNotContain("Scanning");
    }

    @Test
    void missingInternetIsExplained() throws Exception {
        maven("echo 'Downloading from central: x'; echo '[ERROR] Could not transfer artifact a:b'; exit 1");

        Ended start = start("--help");

        assertThat(start.exitCode()).isEqualTo(1);
        assertThat(start.err()).contains("the first build needs the internet");
    }

    @Test
    void failedBuildIsTriedAgain() throws Exception {
        maven("exit 1");
        start("--help");
        maven("mkdir -p app/target; echo jar >app/target/robonewbie.jar");

        Ended second = start("--help");

        assertThat(second.exitCode()).isEqualTo(7);
    }

    @Test
    void oldJavaIsRefusedWithAdvice() throws Exception {
        java(jdk, "1.8.0_401");

        Ended start = start("--help");

        assertThat(start.exitCode()).isEqualTo(1);
        assertThat(start.err()).contains("Java 17 or newer is needed. Found: ", "/java (8)", "Install a JDK");
    }

    @Test
    void newerJavaOfThePathIsTakenInsteadOfAnOldOne() throws Exception {
        java(jdk, "11.0.2");
        java(tools.resolve("newer"), "26-ea");
        Files.createSymbolicLink(tools.resolve("java"), tools.resolve("newer/bin/java"));

        assertThat(start("--help").exitCode()).isEqualTo(7);
    }

    @Test
    void javaWithoutCompilerIsRefusedWithAdvice() throws Exception {
        Files.delete(jdk.resolve("bin/javac"));

        Ended start = start("--help");

        assertThat(start.exitCode()).isEqualTo(1);
        assertThat(start.err()).contains("has no compiler (javac)", "Install a JDK 17");
    }

    @Test
    void twoStartsAtOnceBuildOnce() throws Exception {
        maven("sleep 1; mkdir -p app/target; echo jar >app/target/robonewbie.jar");

        Begun first = begin(home.resolve("robonewbie"), "--help");
        Begun second = begin(home.resolve("robonewbie"), "--help");

        assertThat(end(first).exitCode()).isEqualTo(7);
        assertThat(end(second).exitCode()).isEqualTo(7);
        assertThat(builds()).isEqualTo(1);
    }

    @Test
    void lockOfAKilledBuildIsFree() throws Exception {
        write(home.resolve("app/target/launch/lock"), "");

        assertThat(start("--help").exitCode()).isEqualTo(7);
    }

    @Test
    void javaBesideTheProgramIsTakenFirst() throws Exception {
        Path own = home.resolve("runtime");
        java(own, "25");
        write(own.resolve("release"), "JAVA_RUNTIME_VERSION=\"25.0.3+9-LTS\"\n");
        write(home.resolve("maven/org/robonewbie/robonewbie/2.0.0/robonewbie-2.0.0.jar"), "jar");
        java(jdk, "1.8.0_401");

        Ended start = start("--help");

        assertThat(start.exitCode()).isEqualTo(7);
        assertThat(start.out()).contains("robonewbie-2.0.0-25.0.3+9-LTS.jsa");
    }

    @Test
    void archiveOfClassesIsUsedWhenItIsThere() throws Exception {
        start("--help");
        write(home.resolve("app/target/launch/robonewbie-17.0.15.jsa"), "classes");

        Ended second = start("--help");

        assertThat(second.out())
                .contains("<-XX:SharedArchiveFile=" + home.toRealPath() + "/app/target/launch/robonewbie-17.0.15.jsa>");
    }

    @ParameterizedTest
    @ValueSource(strings = {"LANG=", "LANG=C", "LC_ALL=POSIX", "LC_CTYPE=C", "LANG=xx_XX.UTF-8", "LC_ALL=xx_XX.UTF-8"})
    void javaGetsUtf8WhateverTheShellHas(String setting) throws Exception {
        assumeThat(new String(
                        new ProcessBuilder("locale", "-a")
                                .start()
                                .getInputStream()
                                .readAllBytes(),
                        StandardCharsets.UTF_8))
                .containsIgnoringCase("C.utf");
        write(home.resolve("maven/org/robonewbie/robonewbie/2.0.0/robonewbie-2.0.0.jar"), "jar");

        Ended start = end(begin(List.of(setting), home.resolve("robonewbie"), "--help"));

        assertThat(start.err()).isEmpty();
        assertThat(start.out()).contains("charmap UTF-8,");
    }

    @Test
    void languageOfMessagesStaysWhenTheEncodingIsChanged() throws Exception {
        write(home.resolve("maven/org/robonewbie/robonewbie/2.0.0/robonewbie-2.0.0.jar"), "jar");

        Ended start = end(begin(List.of("LC_ALL=POSIX"), home.resolve("robonewbie"), "--help"));

        assertThat(start.out()).contains("messages POSIX");
    }

    @ParameterizedTest
    @ValueSource(strings = {"a:b", "x \uD83D\uDCBB y", "100% \uD83E\uDD16 Übung"})
    void programInAFolderThatNoClassPathCanNameStartsByAJarThatNamesIt(String name) throws Exception {
        assumeThat(System.getProperty("sun.jnu.encoding")).isEqualTo("UTF-8");
        Path odd = Files.createDirectories(temporaryFolder.resolve(name));
        Path jar = odd.resolve("maven/org/robonewbie/robonewbie/2.0.0/robonewbie-2.0.0.jar");
        Files.copy(Project.ROOT.resolve("robonewbie"), odd.resolve("robonewbie"));
        write(jar, "jar");
        Files.createSymbolicLink(jdk.resolve("bin/jar"), Path.of(System.getProperty("java.home"), "bin", "jar"));

        Ended start = end(begin(List.of("LC_ALL=C.UTF-8"), odd.resolve("robonewbie"), "--help"));

        Matcher link = Pattern.compile("<-Drobonewbie.link=(.*)>").matcher(start.out());
        assertThat(link.find()).as(start.out() + start.err()).isTrue();
        try (JarFile made = new JarFile(link.group(1) + "/robonewbie.jar")) {
            String address = made.getManifest().getMainAttributes().getValue(Attributes.Name.CLASS_PATH);
            assertThat(Path.of(URI.create(address))).isEqualTo(jar.toRealPath());
        } finally {
            TemporaryFolder.delete(Path.of(link.group(1)));
        }
    }

    @Test
    void folderThatCannotBeNamedAtAllIsRefused() throws Exception {
        Path odd = Files.createDirectories(temporaryFolder.resolve("a:b"));
        Files.copy(Project.ROOT.resolve("robonewbie"), odd.resolve("robonewbie"));
        write(odd.resolve("maven/org/robonewbie/robonewbie/2.0.0/robonewbie-2.0.0.jar"), "jar");

        Ended start = end(begin(odd.resolve("robonewbie"), "--help"));

        assertThat(start.exitCode()).isEqualTo(1);
        assertThat(start.err()).contains("a colon or an emoji in its name: ", "/a:b", "Rename or move that folder.");
    }

    @Test
    void stoppedBuildLeavesNothingBehind() throws Exception {
        maven("kill -TERM $PPID; exec sleep 30");

        Ended start = start("--help");

        assertThat(start.exitCode()).isEqualTo(128 + 15);
        assertThat(start.err()).contains("The build was stopped.");
        assertThat(home.resolve("app/target/launch/robonewbie.jar")).doesNotExist();
    }

    @Test
    void toolsOfTheLeagueFindTheServerUnderItsOldNames() throws Exception {
        for (String name : List.of("rcssserver3d", "simspark")) {
            Path script = home.resolve("bin").resolve(name);
            Files.createDirectories(home.resolve("bin"));
            Files.copy(Project.ROOT.resolve("bin").resolve(name), script);

            Ended start = end(begin(script, "--agent-port", "3101", "--server-port", "3201"));

            assertThat(start.out())
                    .contains("<simulator>", "<--process-name>", "<" + name + ">", "<--agent-port>", "<3101>");
        }
    }

    private Ended start(String... arguments) throws Exception {
        return end(begin(home.resolve("robonewbie"), arguments));
    }

    private Begun begin(Path launcher, String... arguments) throws IOException {
        return begin(List.of(), launcher, arguments);
    }

    private Begun begin(List<String> locale, Path launcher, String... arguments) throws IOException {
        List<String> command = new ArrayList<>(List.of("sh", launcher.toString()));
        command.addAll(List.of(arguments));
        Path errors = Files.createTempFile(temporaryFolder, "errors", ".txt");
        ProcessBuilder builder =
                new ProcessBuilder(command).directory(temporaryFolder.toFile()).redirectError(errors.toFile());
        builder.environment().put("JAVA_HOME", jdk.toString());
        builder.environment().put("PATH", tools.toString());
        if (!locale.isEmpty()) {
            builder.environment().keySet().removeIf(name -> name.equals("LANG") || name.startsWith("LC_"));
            locale.stream()
                    .map(setting -> setting.split("=", 2))
                    .forEach(each -> builder.environment().put(each[0], each[1]));
        }
        return new Begun(builder.start(), errors);
    }

    private static Ended end(Begun begun) throws Exception {
        String out = new String(begun.process().getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        int exitCode = begun.process().waitFor();
        return new Ended(exitCode, out, Files.readString(begun.errors()));
    }

    /** A Java that tells its version, runs the build with a real Java, and else tells its arguments; it ends with 7. */
    private static void java(Path folder, String version) throws IOException {
        executable(folder.resolve("bin/javac"), "exit 1");
        executable(folder.resolve("bin/java"), """
                case "$1" in
                  -version) echo 'openjdk version "%s" 2025-04-15' >&2; exit 0 ;;
                  *Build.java) exec '%s/bin/java' -XX:TieredStopAtLevel=1 "$@" ;;
                esac
                echo "in $PWD"
                echo "charmap $(locale charmap 2>&1), messages ${LC_MESSAGES-}"
                for argument in "$@"; do echo "<$argument>"; done
                exit 7
                """.formatted(version, System.getProperty("java.home")));
    }

    /** A Maven that counts how often it is called and then does what the test wants. */
    private void maven(String script) throws IOException {
        executable(home.resolve("mvnw"), "echo build >>../builds.txt\n" + script);
    }

    private int builds() throws IOException {
        return Files.readAllLines(temporaryFolder.resolve("builds.txt")).size();
    }

    private void changeSource() throws IOException {
        Files.setLastModifiedTime(
                home.resolve("app/src/main/java/Main.java"),
                FileTime.from(Instant.now().plusSeconds(5)));
    }

    private static void executable(Path file, String script) throws IOException {
        write(file, "#!/bin/sh\n" + script + "\n");
        assertThat(file.toFile().setExecutable(true)).isTrue();
    }

    private static void write(Path file, String text) throws IOException {
        Files.createDirectories(file.getParent());
        Files.writeString(file, text);
    }

    private static Path find(String tool) {
        return Stream.of("/bin", "/usr/bin")
                .map(folder -> Path.of(folder, tool))
                .filter(Files::exists)
                .findFirst()
                .orElseThrow();
    }
}
