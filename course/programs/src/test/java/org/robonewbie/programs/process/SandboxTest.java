package org.robonewbie.programs.process;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Access of a shell in the sandbox to files. */
class SandboxTest {

    @TempDir
    private Path folder;

    private Path own;

    @BeforeEach
    void createFiles() throws IOException {
        own = Files.createDirectories(folder.resolve("own"));
        Files.writeString(own.resolve("public.txt"), "public");
        Files.writeString(own.resolve("key.txt"), "secret");
        Files.writeString(Files.createDirectories(own.resolve("keys")).resolve("key.txt"), "secret");
        Files.writeString(folder.resolve("other.txt"), "secret");
    }

    @Test
    void absenceIsExplained() {
        Sandbox none = Sandbox.none("bubblewrap is not installed");

        assertThat(none.isUp()).isFalse();
        assertThat(none.absence()).isEqualTo("bubblewrap is not installed");
    }

    @Test
    void readableFilesAreReadAndHiddenOnesAreNot() throws Exception {
        SandboxPolicy policy = new SandboxPolicy(
                List.of(own),
                List.of(own.resolve("key.txt"), own.resolve("keys")),
                Optional.empty(),
                Optional.empty(),
                Optional.empty());

        String read = run(policy, "cat " + own + "/* " + own + "/keys/* " + folder + "/other.txt");

        assertThat(read).contains("public", "other.txt: No such file").doesNotContain("secret");
    }

    @Test
    void filesOfTheProgramAreShownAtTheirPlace() throws Exception {
        SandboxPolicy policy = new SandboxPolicy(
                List.of(), List.of(own.resolve("key.txt")), Optional.of(own), Optional.empty(), Optional.empty());

        String read = run(policy, "cat /team/public.txt /team/key.txt; touch /team/new || echo read-only");

        assertThat(read).startsWith("public").doesNotContain("secret").endsWith("read-only\n");
    }

    @Test
    void onlyTheFolderForResultsIsWritten() throws Exception {
        Path results = Files.createDirectories(folder.resolve("results"));
        SandboxPolicy policy =
                new SandboxPolicy(List.of(own), List.of(), Optional.empty(), Optional.empty(), Optional.of(results));

        run(policy, "touch " + results + "/made " + own + "/made");

        assertThat(results.resolve("made")).exists();
        assertThat(own.resolve("made")).doesNotExist();
    }

    private static String run(SandboxPolicy policy, String script) throws Exception {
        List<String> command = Ground.FENCED.sandbox().enclose(List.of("/bin/sh", "-c", script), policy);
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        process.getOutputStream().close();
        String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        process.waitFor();
        return output;
    }
}
