package org.robonewbie.nao.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.ServerSocketChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Nothing that a folder holds makes its reader wait, read without end, or read the file of another. */
@DisabledOnOs(OS.WINDOWS)
@Timeout(60)
class SubmittedFolderTest {

    @TempDir
    Path folder = Path.of("");

    private Path own = Path.of("");

    @BeforeEach
    void handIn() throws IOException {
        own = Files.createDirectories(folder.resolve("anna"));
        Files.writeString(own.resolve("Kick.java"), "class Kick {}");
        Files.createDirectories(own.resolve("motions"));
        Files.writeString(own.resolve("motions/bow.motion"), "bow");
        Files.writeString(Files.createDirectories(folder.resolve("ben")).resolve("Kick.java"), "class Kick { int b; }");
    }

    private List<Path> files() throws UnreadableFileException {
        return new SubmittedFolder(own, place -> place.endsWith("target")).files();
    }

    private void isRefused(String file, String why) {
        assertThatThrownBy(this::files)
                .isInstanceOf(UnreadableFileException.class)
                .hasMessageContaining("The file " + own.resolve(file) + " ")
                .hasMessageContaining(why);
    }

    @Test
    void regularFilesAreListedInAFixedOrderWithoutWhatIsLeftOut() throws IOException {
        Files.createDirectories(own.resolve("target"));
        Files.createSymbolicLink(own.resolve("target/other"), folder.resolve("ben"));

        assertThat(files()).containsExactly(own.resolve("Kick.java"), own.resolve("motions/bow.motion"));
    }

    @Test
    void linksWithinTheFolderAreFollowedAndCopiedAsFiles() throws IOException {
        Files.createSymbolicLink(own.resolve("moves"), Path.of("motions"));
        Files.createSymbolicLink(own.resolve("Pass.java"), own.resolve("Kick.java"));

        new SubmittedFolder(own, place -> false).copyTo(folder.resolve("copy"));

        assertThat(folder.resolve("copy/moves/bow.motion")).isRegularFile().hasContent("bow");
        assertThat(Files.isSymbolicLink(folder.resolve("copy/Pass.java"))).isFalse();
        assertThat(folder.resolve("copy/Pass.java")).hasContent("class Kick {}");
    }

    @ParameterizedTest
    @CsvSource({
        "motions/Stolen.java, ../../ben/Kick.java, leads out of the folder",
        "lib,                 ../ben,              leads out of the folder",
        "folder beside,       ../anna2,            leads out of the folder",
        "Zero.java,           /dev/zero,           leads out of the folder",
        "notes.txt,           nowhere,             broken link",
        "motions/up,          ..,                  that contains it",
        "ring,                ring,                circular link"
    })
    void badLinkIsRefused(String link, String target, String why) throws IOException {
        Files.createDirectories(folder.resolve("anna2"));
        Files.createSymbolicLink(own.resolve(link), Path.of(target));

        isRefused(link, why);
    }

    @Test
    void linkByWayOfAnInnerLinkIsRefused() throws IOException {
        Files.createSymbolicLink(own.resolve("b"), folder.resolve("ben/Kick.java"));
        Files.createDirectories(own.resolve("z"));
        Files.createSymbolicLink(own.resolve("a"), Path.of("b"));

        assertThatThrownBy(this::files).hasMessageContaining("leads out of the folder");
    }

    @Test
    void folderThatIsALinkItselfIsRefused() throws IOException {
        Files.createSymbolicLink(folder.resolve("eve"), Path.of("ben"));
        own = folder.resolve("eve");

        assertThatThrownBy(this::files).hasMessageContaining("eve is a link. Replace it with its target");
    }

    @Test
    void foldersLinkedManyTimesOverAreNotFollowedWithoutEnd() throws IOException {
        for (int i = 0; i < 20; i++) {
            Path level = Files.createDirectories(own.resolve("f" + i));
            Files.writeString(level.resolve("file"), "");
            Files.createSymbolicLink(level.resolve("a"), Path.of("../f" + (i + 1)));
            Files.createSymbolicLink(level.resolve("b"), Path.of("../f" + (i + 1)));
        }
        Files.createDirectories(own.resolve("f20"));

        assertThatThrownBy(this::files).hasMessageContaining("contains more than 10000 files");
    }

    @Test
    void pipeIsNamedAndNotOpened() throws Exception {
        Process made = new ProcessBuilder("mkfifo", own.resolve("data").toString()).start();
        assumeTrue(made.waitFor(10, TimeUnit.SECONDS) && made.exitValue() == 0, "no mkfifo here");

        isRefused("data", "is not a regular file but a device, a pipe or a socket");
    }

    @Test
    void socketIsNamedAndNotOpened() throws IOException {
        try (ServerSocketChannel socket = ServerSocketChannel.open(StandardProtocolFamily.UNIX)) {
            socket.bind(UnixDomainSocketAddress.of(own.resolve("s")));

            isRefused("s", "is not a regular file");
        }
    }

    @Test
    void hugeFileIsRefusedByItsSize() throws IOException {
        try (RandomAccessFile sparse =
                new RandomAccessFile(own.resolve("data.bin").toFile(), "rw")) {
            sparse.setLength(SubmittedFolder.MAX_BYTES + 1);
        }

        assertThatThrownBy(this::files).hasMessageContaining("contains more than 100 MB");
    }

    @Test
    void deepFoldersAreRefused() throws IOException {
        Path deep = own;
        for (int i = 0; i <= SubmittedFolder.MAX_DEPTH; i++) {
            deep = deep.resolve("d");
        }
        Files.createDirectories(deep);

        assertThatThrownBy(this::files).hasMessageContaining("is nested more than 40 folders deep");
    }

    @Test
    void hardLinkIsARegularFile() throws IOException {
        Files.createLink(own.resolve("Hard.java"), folder.resolve("ben/Kick.java"));

        assertThat(files()).contains(own.resolve("Hard.java"));
    }

    @Test
    void hostileNamesAreHarmlessAndShownOnOneLine() throws IOException {
        Files.writeString(own.resolve("-rf"), "");
        Files.writeString(own.resolve("n".repeat(250)), "");
        Files.createSymbolicLink(own.resolve("a\nb\u001b[31m\u202etxt"), Path.of("/etc/passwd"));

        assertThatThrownBy(this::files).hasMessageContaining("a\\nb\\u001B[31m\\u202Etxt is a link that leads out");
        Files.delete(own.resolve("a\nb\u001b[31m\u202etxt"));
        Files.writeString(own.resolve("a\nb"), "");
        assertThat(files()).contains(own.resolve("-rf"), own.resolve("a\nb"));
    }
}
