package org.robonewbie.studio.program;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.nao.file.UnreadableFileException;
import org.robonewbie.studio.file.PageFolder;
import org.robonewbie.studio.file.RefusedException;

/** Programs are read and written in their folder only, and never overwrite changes of another program. */
class ProgramFolderTest {

    @TempDir
    private Path place;

    private ProgramFolder folder = new ProgramFolder(Path.of(""));

    @BeforeEach
    void open() throws IOException {
        folder = new ProgramFolder(Files.createDirectory(place.resolve("mine")));
        Files.writeString(place.resolve("Secret.java"), "class Secret {}");
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "../Secret.java",
                "/etc/Secret.java",
                "a/../../Secret.java",
                "..\\Secret.java",
                "Secret.txt",
                ".java",
                ".hidden/A.java",
                "con.java",
                "aux/A.java",
                "A.java\u0000"
            })
    void namesThatLeadElsewhereAreRefused(String path) {
        assertThatThrownBy(() -> folder.read(path)).isInstanceOf(RefusedException.class);
        assertThatThrownBy(() -> folder.overwrite(path, bytes("class A {}"))).isInstanceOf(RefusedException.class);
    }

    @Test
    void linkThatLeadsOutIsRefused() throws IOException {
        Files.createSymbolicLink(folder.folder().resolve("Link.java"), place.resolve("Secret.java"));
        Files.createSymbolicLink(folder.folder().resolve("out"), place);

        assertThatThrownBy(() -> folder.read("Link.java")).hasMessageContaining("a link to a place outside");
        assertThatThrownBy(() -> folder.overwrite("out/Secret.java", bytes("")))
                .hasMessageContaining("a link to a place outside");
        assertThat(place.resolve("Secret.java")).hasContent("class Secret {}");
    }

    @Test
    @Timeout(20)
    void irregularFileIsSkippedAndNeverOpened() throws IOException, InterruptedException {
        folder.overwrite("Kick.java", bytes("class Kick {}"));
        Path pipe = folder.folder().resolve("Pipe.java");
        assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor())
                .isZero();
        try (RandomAccessFile huge =
                new RandomAccessFile(folder.folder().resolve("Huge.java").toFile(), "rw")) {
            huge.setLength(3_000_000_000L);
        }
        Files.createDirectory(folder.folder().resolve("Folder.java"));

        assertThat(folder.list()).extracting(PageFolder.Entry::path).containsExactly("Kick.java");
        for (String name : List.of("Pipe.java", "Huge.java", "Folder.java")) {
            assertThatThrownBy(() -> folder.read(name))
                    .isInstanceOf(UnreadableFileException.class)
                    .hasMessageContaining(name + " is ");
            assertThatThrownBy(() -> folder.write(name, bytes("class A {}"), ""))
                    .isInstanceOf(UnreadableFileException.class);
        }
    }

    @Test
    void filesOfTheFolderAndOfItsProjectAreListed() throws IOException {
        folder.overwrite("src/main/java/my/team/Attacker.java", bytes("class Attacker {}"));
        folder.overwrite("Kick.java", bytes("class Kick {}"));
        folder.overwrite("other/Hidden.java", bytes("class Hidden {}"));

        assertThat(folder.list())
                .extracting(PageFolder.Entry::path)
                .containsExactly("Kick.java", "src/main/java/my/team/Attacker.java");
    }

    @Test
    void changesOfAnotherProgramAreKept() throws IOException {
        String seen = folder.write("A.java", bytes("class A {}"), "");
        folder.overwrite("A.java", bytes("class A { int other; }"));

        assertThatThrownBy(() -> folder.write("A.java", bytes("class A { int mine; }"), seen))
                .hasMessage(
                        "\"A.java\" was changed by another program after it was opened here. Reload it, or save it under another name.");
        assertThatThrownBy(() -> folder.write("A.java", bytes("class A { int mine; }"), ""))
                .hasMessage("There is already a file named \"A.java\". Choose another name.");
        assertThat(folder.folder().resolve("A.java")).hasContent("class A { int other; }");
    }
}
