package org.robonewbie.site;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The commit of a build is known in a working tree and in an archive. */
class CommitTest {

    private static final String ID = "0839a7085d2c1d3f5f8a0d6a4a0d7f6f1b2c3d4e";

    @TempDir
    private Path folder;

    @Test
    void archiveNamesItsCommit() throws IOException {
        writeCommit(ID);

        assertThat(Commit.of(folder)).isEqualTo("0839a708");
    }

    @Test
    void folderWithoutCommitHasNoId() throws IOException {
        writeCommit("$Format:%H$");

        assertThat(Commit.of(folder)).isEmpty();
    }

    @Test
    void workingTreeTellsWhetherItIsModified() throws Exception {
        assumeTrue(git("init", "-q"), "Git is not installed.");
        Path file = Files.writeString(folder.resolve("Step.java"), "class Step {}");
        git("add", ".");
        git("-c", "user.name=a", "-c", "user.email=a@example.org", "commit", "-q", "-m", "first");

        String clean = Commit.of(folder);
        Files.writeString(file, "class Step { int metres; }");

        assertThat(clean).matches("\\p{XDigit}{8}");
        assertThat(Commit.of(folder)).isEqualTo(clean + "-modified");
    }

    @Test
    void repositoryAroundTheProjectDoesNotCount() throws Exception {
        assumeTrue(git("init", "-q"), "Git is not installed.");
        git("-c", "user.name=a", "-c", "user.email=a@example.org", "commit", "-q", "--allow-empty", "-m", "first");

        assertThat(Commit.of(Files.createDirectory(folder.resolve("project")))).isEmpty();
    }

    private void writeCommit(String content) throws IOException {
        Files.createDirectory(folder.resolve("release"));
        Files.writeString(folder.resolve("release/commit.txt"), content + "\n");
    }

    private boolean git(String... arguments) throws InterruptedException {
        List<String> command =
                Stream.concat(Stream.of("git"), Stream.of(arguments)).toList();
        try {
            return new ProcessBuilder(command)
                            .directory(folder.toFile())
                            .start()
                            .waitFor()
                    == 0;
        } catch (IOException notInstalled) {
            return false;
        }
    }
}
