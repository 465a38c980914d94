package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.programs.CompilerOfThisJava;

/** A Java without a compiler runs what is compiled, and says what is missing for the rest. */
class CompilerOfThisJavaTest {

    private static final Path BIN = Path.of(System.getProperty("java.home"), "bin");

    @TempDir
    private Path folder;

    @Test
    void testsRunOnAJdk() {
        assertThat(CompilerOfThisJava.isThere()).isTrue();
    }

    @Tag("slow")
    @ParameterizedTest
    @ValueSource(strings = {"java.se", "java.desktop,java.logging,java.management,java.net.http,java.xml"})
    void runTimeWithoutCompilerSaysWhatToInstall(String modules) throws Exception {
        Path java = folder.resolve("jre");
        run(List.of(
                BIN.resolve("jlink").toString(),
                "--add-modules",
                modules + ",jdk.unsupported,jdk.httpserver,jdk.zipfs,jdk.management",
                "--output",
                java.toString()));
        Files.writeString(folder.resolve("Idle.java"), "class Idle {}");

        String wrong = robonewbie(java, "run", "Idle.java");
        String right = robonewbie(java, "run", "Agent_BasicStructure", "--headless", "--fast", "--seconds", "2");

        assertThat(wrong)
                .startsWith("robonewbie: To run .java files, install a JDK instead of a Java runtime (JRE)")
                .doesNotContain("at org.robonewbie");
        assertThat(right).contains("left shoulder pitch 31.20 degrees");
    }

    private String robonewbie(Path java, String... words) throws Exception {
        List<String> command = new ArrayList<>(List.of(
                java.resolve("bin/java").toString(),
                "-cp",
                System.getProperty("java.class.path"),
                "org.robonewbie.app.Main"));
        command.addAll(List.of(words));
        return run(command);
    }

    private String run(List<String> command) throws IOException, InterruptedException {
        Process process = new ProcessBuilder(command)
                .directory(folder.toFile())
                .redirectErrorStream(true)
                .start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        process.waitFor();
        return said;
    }
}
