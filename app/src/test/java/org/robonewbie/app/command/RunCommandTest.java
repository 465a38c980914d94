package org.robonewbie.app.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.app.Printed;
import org.robonewbie.programs.process.JavaCommand;

class RunCommandTest {

    @TempDir
    Path temporaryFolder;

    private Path folder = Path.of("");

    @BeforeEach
    void makeFolderWithBlanks() throws IOException {
        folder = Files.createDirectories(temporaryFolder.resolve("my first robots"));
    }

    @Test
    void unknownAgentIsAnsweredWithTheListOfExamples() {
        Printed answer = Printed.by("run", "Agent_DoesNotExist");

        assertThat(answer.exitCode()).isEqualTo(2);
        assertThat(answer.err()).contains("There is no agent \"Agent_DoesNotExist\".", "The examples are:");
    }

    @Test
    void missingAgentIsAskedForAndEachExampleIsDescribed() {
        Printed answer = Printed.by("run");

        assertThat(answer.exitCode()).isEqualTo(2);
        assertThat(answer.err()).contains("Which agent do you want to run?");
        assertThat(answer.err().lines().filter(line -> line.startsWith("  Agent_")))
                .contains("  Agent_BasicStructure         Lesson 2: the basic structure of an agent.")
                .hasSizeGreaterThan(15)
                .allMatch(line -> line.matches("  Agent_\\w+ +[A-Z][^{}]*\\."));
    }

    @Test
    void optionsBeforeTheAgentAreExplained() {
        Printed answer = Printed.by("run", "--headless", "Agent_BasicStructure");

        assertThat(answer.exitCode()).isEqualTo(2);
        assertThat(answer.err()).contains("The agent comes before its options:");
    }

    @Test
    void javaFileRunsWithAllFurtherOptions() throws IOException {
        Path file = write("Greeting.java", program("Greeting", "System.out.println(String.join(\"|\", args));"));

        Printed answer = Printed.by("run", file.toString(), "--seed", "3", "--help");

        assertThat(answer.out().strip()).isEqualTo("--seed|3|--help");
        assertThat(answer.exitCode()).isZero();
    }

    @Test
    void rehearsalIsUnseenAndHasASimulatorOfItsOwn() throws IOException {
        String words = "System.out.println(String.join(\"|\", args)); System.out.println(++count);";
        Path file = write(
                "Twice.java",
                "public class Twice { static int count; public static void main(String[] args) { " + words + " } }");

        Printed answer = Printed.by("run", "--rehearse", "5", file.toString(), "--port", "3100", "7");

        assertThat(answer.out().lines()).containsExactly("Rehearsing for 5.0 simulated seconds", "--port|3100|7", "2");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"--port 3100", "--port=3100", "--host 127.0.0.1 --port 3100", "--host=127.0.0.1 --port=3100"})
    void rehearsalJoinsNoServer(String server) throws IOException {
        Path arguments = folder.resolve("arguments.txt");
        Path file = write(
                "Writer.java",
                "import java.nio.file.*; import static java.nio.file.StandardOpenOption.*;"
                        + " public class Writer { public static void main(String[] args) throws Exception {"
                        + " Files.writeString(Path.of(\"" + arguments.toString().replace("\\", "\\\\")
                        + "\"), String.join(\" \", args) + \"\\n\", CREATE, APPEND); } }");

        Printed.by(Stream.concat(
                        Stream.of("run", "--rehearse", "5", file.toString()), Stream.of((server + " 7").split(" ")))
                .toArray(String[]::new));

        assertThat(arguments).content().isEqualTo("7 --seed 1 --fast --headless --seconds 5.0\n" + server + " 7\n");
    }

    @Test
    void rehearsalOfLessThanNothingIsRefused() {
        Printed answer = Printed.by("run", "--rehearse", "-1", "Agent_BasicStructure");

        assertThat(answer.exitCode()).isEqualTo(2);
        assertThat(answer.err()).contains("--rehearse -1.0 is not valid. Use a number of seconds, at least 0.");
    }

    @Test
    void javaFileUsesItsNeighbours() throws IOException {
        write("Other.java", "class Other { static String word() { return \"neighbour\"; } }");
        Path file = write("Caller.java", program("Caller", "System.out.println(Other.word());"));

        Printed answer = Printed.by("run", file.toString());

        assertThat(answer.out().strip()).isEqualTo("neighbour");
    }

    @Test
    void javaFileInPackageUsesItsNeighbours() throws IOException {
        write("red/team/Other.java", "package red.team; class Other { static String word() { return \"red\"; } }");
        Path file = write(
                "red/team/Caller.java", "package red.team;" + program("Caller", "System.out.println(Other.word());"));

        Printed answer = Printed.by("run", file.toString());

        assertThat(answer.out().strip()).isEqualTo("red");
    }

    @Test
    void javaFileLeavesNoFilesBehind() throws IOException {
        Path file = write("Tidy.java", program("Tidy", "new Object() {};"));

        Printed.by("run", file.toString());

        try (var files = Files.list(folder)) {
            assertThat(files).containsExactly(file);
        }
    }

    @Test
    void mistakeInJavaFileIsShownWithItsLine() throws IOException {
        Path file = write("Broken.java", "public class Broken {\n    int angle = \"thirty\";\n}\n");

        Printed answer = Printed.by("run", file.toString());

        assertThat(answer.exitCode()).isEqualTo(1);
        assertThat(answer.err()).contains("Broken.java:2: error", "thirty", "Fix the first one above");
    }

    @Test
    void missingJavaFileIsNamedWithItsFolder() {
        Printed answer = Printed.by("run", "Missing.java");

        assertThat(answer.exitCode()).isEqualTo(2);
        assertThat(answer.err())
                .contains(
                        "The file Missing.java does not exist in the folder",
                        Path.of("").toAbsolutePath().toString());
    }

    @Test
    void classWithoutMainIsToldHowToGetOne() throws IOException {
        Path file = write("Idle.java", "public class Idle {}");

        Printed answer = Printed.by("run", file.toString());

        assertThat(answer.exitCode()).isEqualTo(2);
        assertThat(answer.err())
                .contains(
                        "Idle cannot be run, since it has no main method.",
                        "public class Idle extends Agent",
                        "new Idle().run(args);");
    }

    @Test
    void classThatIsNamedUnlikeItsFileIsExplained() throws IOException {
        Path file = write("Left.java", "class Right {}");

        Printed answer = Printed.by("run", file.toString());

        assertThat(answer.exitCode()).isEqualTo(2);
        assertThat(answer.err()).contains("has no class Left", "must have the same name");
    }

    @Test
    void exceptionOfTheAgentIsShownFromItsOwnLinesOn() throws IOException {
        Path file = write("Falling.java", program("Falling", "throw new IllegalStateException(\"tripped\");"));

        Printed answer = Printed.by("run", file.toString());

        assertThat(answer.exitCode()).isEqualTo(1);
        assertThat(answer.err())
                .contains("Falling ended with java.lang.IllegalStateException: tripped", "Falling.java:")
                .doesNotContain("jdk.internal.reflect");
    }

    @Test
    void ownClassOnTheClassPathRuns() throws IOException {
        Path file = write("Compiled.java", program("Compiled", "System.out.println(\"from a class file\");"));
        javax.tools.ToolProvider.getSystemJavaCompiler().run(null, null, null, file.toString());

        Printed answer = Printed.by("run", "--class-path", folder.toString(), "Compiled");

        assertThat(answer.out().strip()).isEqualTo("from a class file");
    }

    @Tag("slow")
    @Test
    void interruptedRunPrintsNoErrors() throws Exception {
        Path program = write("Thinking.java", """
                import org.robonewbie.agent.Agent;

                public class Thinking extends Agent {
                    public static void main(String[] args) {
                        new Thinking().run(args);
                    }

                    @Override
                    protected void think() {
                        System.out.println("thinking");
                    }
                }
                """);
        Path errors = folder.resolve("errors.txt");
        Process run = new ProcessBuilder(
                        JavaCommand.ofCommand(List.of("run", program.toString(), "--no-browser", "--seed", "1")))
                .directory(folder.toFile())
                .redirectError(errors.toFile())
                .start();
        try (BufferedReader output = run.inputReader()) {
            assertThat(output.lines().anyMatch("thinking"::equals)).isTrue();

            run.toHandle().destroy();
            output.transferTo(Writer.nullWriter());
        }
        run.waitFor();
        assertThat(errors).hasContent("");
    }

    private Path write(String name, String text) throws IOException {
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        return Files.writeString(file, text);
    }

    private static String program(String name, String statements) {
        return "public class " + name + " { public static void main(String[] args) { " + statements + " } }";
    }
}
