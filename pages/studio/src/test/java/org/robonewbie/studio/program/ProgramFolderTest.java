package org.robonewbie.studio.program;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.nao.file.UnreadableFileException;
import org.robonewbie.nao.text.FileName;
import org.robonewbie.studio.file.PageFiles;
import org.robonewbie.studio.file.RefusedException;

/** Programs are read and written in their folder only, and never overwrite changes of another program. */
class ProgramFolderTest {

    private static final Path SCRIPT =
            Path.of("src/main/resources/org/robonewbie/studio/web/state/file-name-patterns.js");

    @TempDir
    private Path place;

    private ProgramFolder folder = ProgramFolder.of(Path.of(""));

    @BeforeEach
    void open() throws IOException {
        folder = ProgramFolder.of(Files.createDirectory(place.resolve("mine")));
        Files.writeString(place.resolve("Secret.java"), "class Secret {}");
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    /** The patterns that the scripts of studio and web edition use; {@code -Dtables=write} writes them. */
    @Test
    void scriptsHaveTheSamePatterns() throws IOException {
        String problems = FileName.PROBLEMS.stream()
                .map(each -> "  { pattern: /%s/iu, words: '%s' },\n".formatted(each.pattern(), each.words()))
                .collect(Collectors.joining());
        String script = """
                /** Patterns of file names: those of the Java classes FileName and ProgramFolder, whose test writes this file. */

                export const MAX_CHARACTERS = %d;

                // prettier-ignore
                export const INVALID = /%s/u;

                // prettier-ignore
                export const PROBLEMS = [
                %s];

                export const PROGRAM_PATH = /^%s$/u;
                """.formatted(
                        FileName.MAX_CHARACTERS,
                        FileName.INVALID,
                        problems,
                        ProgramFolder.PATH.pattern().replace("/", "\\/"));
        if (System.getProperty("tables", "").equals("write")) {
            Files.writeString(SCRIPT, script);
        }

        assertThat(SCRIPT).hasContent(script);
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
        assertThatThrownBy(() -> folder.write(path, bytes("class A {}"), Optional.empty()))
                .isInstanceOf(RefusedException.class);
    }

    @Test
    void linkThatLeadsOutIsRefused() throws IOException {
        Files.createSymbolicLink(folder.folder().resolve("Link.java"), place.resolve("Secret.java"));
        Files.createSymbolicLink(folder.folder().resolve("out"), place);

        assertThatThrownBy(() -> folder.read("Link.java")).hasMessageContaining("a link to a place outside");
        assertThatThrownBy(() -> folder.write("out/Secret.java", bytes(""), Optional.empty()))
                .hasMessageContaining("a link to a place outside");
        assertThat(place.resolve("Secret.java")).hasContent("class Secret {}");
    }

    @Test
    @Timeout(20)
    void irregularFileIsSkippedAndNeverOpened() throws IOException, InterruptedException {
        folder.write("Kick.java", bytes("class Kick {}"), Optional.empty());
        Path pipe = folder.folder().resolve("Pipe.java");
        assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor())
                .isZero();
        try (RandomAccessFile huge =
                new RandomAccessFile(folder.folder().resolve("Huge.java").toFile(), "rw")) {
            huge.setLength(3_000_000_000L);
        }
        Files.createDirectory(folder.folder().resolve("Folder.java"));

        assertThat(folder.list().files()).extracting(PageFiles.Entry::path).containsExactly("Kick.java");
        for (String name : List.of("Pipe.java", "Huge.java", "Folder.java")) {
            assertThatThrownBy(() -> folder.read(name))
                    .isInstanceOf(UnreadableFileException.class)
                    .hasMessageContaining(name + " is ");
            assertThatThrownBy(() -> folder.write(name, bytes("class A {}"), Optional.of("")))
                    .isInstanceOf(UnreadableFileException.class);
        }
    }

    @Test
    void filesOfTheFolderAndOfItsProjectAreListed() throws IOException {
        folder.write("src/main/java/my/team/Attacker.java", bytes("class Attacker {}"), Optional.empty());
        folder.write("Kick.java", bytes("class Kick {}"), Optional.empty());
        folder.write("other/Hidden.java", bytes("class Hidden {}"), Optional.empty());

        assertThat(folder.list().files())
                .extracting(PageFiles.Entry::path)
                .containsExactly("Kick.java", "src/main/java/my/team/Attacker.java");
    }

    @Test
    void changesOfAnotherProgramAreKept() throws IOException {
        String seen = folder.write("A.java", bytes("class A {}"), Optional.of(""));
        folder.write("A.java", bytes("class A { int other; }"), Optional.of(seen));

        assertThatThrownBy(() -> folder.write("A.java", bytes("class A { int mine; }"), Optional.of(seen)))
                .hasMessage(
                        "\"A.java\" was changed by another program after it was opened here. Reload it, or save it under another name.");
        assertThatThrownBy(() -> folder.write("A.java", bytes("class A { int mine; }"), Optional.of("")))
                .hasMessage("There is already a program named \"A.java\". Choose another name.");
        assertThat(folder.folder().resolve("A.java")).hasContent("class A { int other; }");
    }
}
