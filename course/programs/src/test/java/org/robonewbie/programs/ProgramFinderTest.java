package org.robonewbie.programs;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ProgramFinderTest {

    private static final String MAIN =
            "public static void main(String[] args) { System.setProperty(args[0], \"ran\"); }";

    @TempDir
    private Path folder;

    @Test
    void javaFileIsCompiledAndRun() throws IOException {
        Path file = write("Counts.java", "public class Counts { " + MAIN + " }");

        int exitCode = finder().find(file.toString()).run(List.of("finder.test.file"));

        assertThat(exitCode).isZero();
        assertThat(System.getProperty("finder.test.file")).isEqualTo("ran");
    }

    @Test
    void compiledClassIsFoundInItsFolder() throws IOException {
        write("Counts.java", "public class Counts { " + MAIN + " }");
        new SourceFolder(folder, false).compile(folder);

        int exitCode = finder().ofClass("Counts").run(List.of("finder.test.class"));

        assertThat(exitCode).isZero();
        assertThat(System.getProperty("finder.test.class")).isEqualTo("ran");
    }

    @Test
    void repeatedRunsHaveTheirOwnStaticFields() throws Exception {
        Path file = write("Counts.java", "public class Counts { public static int count; " + MAIN + " }");
        Supplier<Class<?>> classes = finder().findClass(file.toString());

        classes.get().getField("count").setInt(null, 7);

        assertThat(classes.get().getField("count").getInt(null)).isZero();
        assertThat(finder().findRepeatedly(file.toString()).get()).isNotNull();
    }

    @ParameterizedTest
    @CsvSource({"throw new IllegalStateException();, 1", "args[9] = null;, 1", "'', 0"})
    void exceptionOfAProgramIsItsExitCode(String body, int exitCode) throws IOException {
        Path file = write(
                "Throws.java", "public class Throws { public static void main(String[] args) { %s } }".formatted(body));

        assertThat(finder().find(file.toString()).run(List.of())).isEqualTo(exitCode);
    }

    @Test
    void unknownProgramIsAnsweredWithAdvice() {
        assertThatThrownBy(() -> finder().find("Nobody"))
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageContaining("There is no agent \"Nobody\".")
                .hasMessageContaining("To run your own agent, name its file, for example: robonewbie run MyAgent.java");
        assertThatThrownBy(() -> finder().ofClass("Nobody")).isInstanceOf(CalledWronglyException.class);
    }

    @ParameterizedTest
    @CsvSource({"'', It is not a robot either", "extends org.robonewbie.agent.Agent, new Idle().run(args);"})
    void programWithoutMainMethodIsAnsweredWithTheMissingLines(String parent, String advice) throws IOException {
        String think = parent.isEmpty() ? "" : "@Override protected void think() {}";
        Path file = write("Idle.java", "public class Idle " + parent + " { " + think + " }");

        assertThatThrownBy(() -> finder().find(file.toString()))
                .hasMessageStartingWith("Idle cannot be run, since it has no main method.")
                .hasMessageContaining(advice);
    }

    @Test
    void examplesAreThoseOnTheClassPath() {
        ExampleSources sources = new ExampleSources();

        assertThat(ExampleCatalogue.classNames()).isEqualTo(Map.of());
        assertThat(sources.names()).isEmpty();
        assertThat(sources.text("Agent_Wave")).isEmpty();
    }

    @Test
    void newProgramIsNamedAfterItsFile() {
        ExampleSources sources = new ExampleSources();

        String shortest = sources.startingWith(folder.resolve("Kicker.java"), Optional.empty());
        String inProject =
                sources.startingWith(folder.resolve("src/main/java/de/uni/Kicker.java"), Optional.of("text"));

        assertThat(shortest).contains("public class Kicker extends Agent", "new Kicker().run(args);");
        assertThat(inProject).isEqualTo("package de.uni;\n\ntext");
    }

    private ProgramFinder finder() {
        return new ProgramFinder(List.of(folder));
    }

    private Path write(String name, String text) throws IOException {
        return Files.writeString(folder.resolve(name), text);
    }
}
