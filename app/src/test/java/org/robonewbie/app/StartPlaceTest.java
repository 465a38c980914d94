package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.programs.ClassPath;
import org.robonewbie.programs.process.JavaCommand;

/** Starts the program without its launcher in shells and folders that are not as usual. */
@Tag("slow")
@EnabledOnOs(OS.LINUX)
@Timeout(120)
class StartPlaceTest {

    private static final String ADVICE =
            "since the encoding of this shell is ANSI_X3.4-1968. Run \"export LC_ALL=C.UTF-8\"";

    private static final String PROGRAM = """
            import org.robonewbie.agent.Agent;

            public class Standing extends Agent {
                public static void main(String[] args) {
                    new Standing().run(args);
                }

                @Override
                protected void think() {
                    log.info("Grüße");
                }
            }
            """;

    @TempDir
    Path temporary = Path.of("");

    private record Ended(int exitCode, String said) {}

    @ParameterizedTest
    @ValueSource(
            strings = {
                "new team",
                "grade raise-arms --start",
                "run Agent_Wave --headless --fast --seconds 1",
                "simulator"
            })
    void nothingIsWrittenWhereTheFolderCannotBeRead(String command) throws Exception {
        Path folder = folder("Übung 1");

        Ended ended = start("C", List.of(), folder, command.split(" "));

        assertThat(ended.exitCode()).isEqualTo(2);
        assertThat(ended.said())
                .contains("contains letters that cannot be decoded, " + ADVICE)
                .hasLineCount(1);
        assertThat(folder).isEmptyDirectory();
        assertThat(filesIn(temporary)).containsExactly(folder);
    }

    @Test
    void argumentThatCannotBeReadIsRefused() throws Exception {
        Ended ended = start("POSIX", List.of(), temporary, "run", "Agent_Wave", "--headless", "--report", "größe.json");

        assertThat(ended.exitCode()).isEqualTo(2);
        assertThat(ended.said()).contains(ADVICE).hasLineCount(1);
        assertThat(temporary).isEmptyDirectory();
    }

    @ParameterizedTest
    @ValueSource(strings = {"doctor", "doctor --course", "doctor --course --headless"})
    void checksNameTheEncodingAndEnd(String command) throws Exception {
        Ended ended = start("C", List.of(), folder("Übung 1"), command.split(" "));

        assertThat(ended.exitCode()).isEqualTo(1);
        assertThat(ended.said()).contains("FAIL  Encoding ", ADVICE).doesNotContain("Exception", "\tat ");
    }

    @ParameterizedTest
    @ValueSource(strings = {"Übung 1", "a:b", "x \uD83D\uDCBB", "100% %p", "q'x\"y", "a+b#c&d;e!f$g(h)[i]{j}"})
    void programsRunInFoldersOfAllNames(String name) throws Exception {
        Path folder = folder(name);
        Files.writeString(folder.resolve("Standing.java"), PROGRAM);

        Ended ended = start(
                "C.UTF-8",
                List.of(),
                folder,
                "run",
                "Standing.java",
                "--headless",
                "--fast",
                "--seed",
                "1",
                "--seconds",
                "1");

        assertThat(ended.said()).contains("Grüße");
        assertThat(ended.exitCode()).isZero();
    }

    @Test
    void runThatIsOverBeforeItBeginsSaysSo() throws Exception {
        Ended ended =
                start("C.UTF-8", List.of(), temporary, "run", "Agent_Wave", "--headless", "--fast", "--seconds", "0.2");

        assertThat(ended.exitCode()).isEqualTo(2);
        assertThat(ended.said()).contains("--seconds 0.2 is too short: joining takes about 0.3 s. Use at least 1.");
    }

    @Test
    void missingFolderForTemporaryFilesIsNamedWithWhatToDo() throws Exception {
        Path missing = temporary.resolve("missing");
        Files.writeString(Files.createDirectory(temporary.resolve("anna")).resolve("Standing.java"), PROGRAM);

        Ended ended = start("C.UTF-8", List.of("-Djava.io.tmpdir=" + missing), temporary, "grade", "--class", ".");

        assertThat(ended.exitCode()).isEqualTo(1);
        assertThat(ended.said())
                .contains("The system's folder for temporary files, " + missing + ", does not exist")
                .contains("JAVA_TOOL_OPTIONS=-Djava.io.tmpdir=FOLDER");
    }

    @ParameterizedTest
    @ValueSource(strings = {"C", "C.UTF-8"})
    void studentWhoseFolderCannotBeReadIsAFindingAndTheOthersAreGraded(String locale) throws Exception {
        Path folder = Files.createDirectories(temporary.resolve("class"));
        Files.writeString(
                Files.createDirectories(folder.resolve("anna")).resolve("RaiseArms.java"), "class RaiseArms {}");
        Process latin = new ProcessBuilder(
                        "sh", "-c", "mkdir \"$(printf 'J\\366rg')\" && cp anna/RaiseArms.java \"$(printf 'J\\366rg')\"")
                .directory(folder.toFile())
                .start();
        assertThat(latin.waitFor()).isZero();

        Ended ended = start(locale, List.of(), temporary, "grade", "raise-arms", "--class", "class", "--seeds", "1");

        assertThat(ended.said()).contains("2 students, 1 programs").doesNotContain("Exception");
        assertThat(Files.readString(temporary.resolve("class-grades/grades.csv")))
                .contains("anna", "rg,", "The name \"");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "void main() { System.out.println(\"begun \" + List.of(1)); }",
                "class Short { void main(String[] args) { System.out.println(\"begun \" + args.length); } }",
                "static void main() { IO.println(\"begun\"); }"
            })
    void java25BeginsWithItsShortForms(String text) throws Exception {
        Optional<Path> java = java25();
        assumeThat(java).isPresent();
        Files.writeString(temporary.resolve("Short.java"), text);

        Ended ended = start(java.get(), "C.UTF-8", List.of(), temporary, "run", "Short.java");

        assertThat(ended.said()).startsWith("begun");
        assertThat(ended.exitCode()).isZero();
    }

    private static Optional<Path> java25() throws IOException {
        Path all = Path.of("/usr/lib/jvm");
        if (!Files.isDirectory(all)) {
            return Optional.empty();
        }
        return filesIn(all).stream()
                .filter(jdk -> jdk.toString().contains("25"))
                .map(jdk -> jdk.resolve("bin/java"))
                .filter(Files::isExecutable)
                .findFirst();
    }

    @Test
    void programThatIsNoAgentAndFindsNoServerIsToldHowToStartOne() throws Exception {
        Files.writeString(temporary.resolve("Raw.java"), """
                public class Raw {
                    public static void main(String[] args) throws Exception {
                        new java.net.Socket("127.0.0.1", 1).close();
                    }
                }
                """);

        Ended ended = start("C.UTF-8", List.of(), temporary, "run", "Raw.java");

        assertThat(ended.exitCode()).isEqualTo(1);
        assertThat(ended.said()).contains("ConnectException", "start one first: robonewbie simulator");
    }

    private Path folder(String name) throws IOException {
        assumeThat(System.getProperty("sun.jnu.encoding")).isEqualTo("UTF-8");
        return Files.createDirectories(temporary.resolve(name));
    }

    private static List<Path> filesIn(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.toList();
        }
    }

    private static Ended start(String locale, List<String> javaOptions, Path folder, String... words) throws Exception {
        return start(Path.of(System.getProperty("java.home"), "bin", "java"), locale, javaOptions, folder, words);
    }

    private static Ended start(Path java, String locale, List<String> javaOptions, Path folder, String... words)
            throws Exception {
        List<String> options = new ArrayList<>(javaOptions);
        options.add(JavaCommand.QUICK_START);
        List<String> command = new ArrayList<>(
                JavaCommand.of(options, ClassPath.ofThisProgram(), "org.robonewbie.app.Main", List.of(words)));
        command.set(0, java.toString());
        ProcessBuilder builder =
                new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true);
        builder.environment().put("LC_ALL", locale);
        builder.environment().put("ROBONEWBIE_RECORDINGS", "off");
        Process process = builder.start();
        process.getOutputStream().close();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        return new Ended(process.waitFor(), said.strip());
    }
}
