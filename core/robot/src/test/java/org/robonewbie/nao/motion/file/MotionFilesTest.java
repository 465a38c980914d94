package org.robonewbie.nao.motion.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.text.Normalizer;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.nao.file.UnreadableFileException;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.MotionLibrary;

class MotionFilesTest {

    private static final String NOD = "200" + " 0".repeat(22) + "\n";

    @TempDir
    private Path folder;

    private MotionFiles files = new MotionFiles(Path.of(""));

    @BeforeEach
    void open() {
        files = new MotionFiles(folder);
    }

    @ParameterizedTest
    @ValueSource(strings = {"grüßen", "día", "приседание", "नमस्ते", "각도", "ǖ x", "wave (1)"})
    void nameIsOneInEitherFormOfItsLetters(String name) throws IOException {
        String composed = Normalizer.normalize(name, Normalizer.Form.NFC);
        for (Normalizer.Form form : List.of(Normalizer.Form.NFC, Normalizer.Form.NFD)) {
            Path file = Files.writeString(folder.resolve(Normalizer.normalize(name, form) + ".txt"), NOD);

            assertThat(files.names()).containsExactly(composed);
            for (Normalizer.Form asked : Normalizer.Form.values()) {
                assertThat(Normalizer.normalize(name, asked))
                        .satisfiesAnyOf(
                                known -> assertThat(files.read(known)).isPresent(),
                                other -> assertThat(Normalizer.normalize(other, Normalizer.Form.NFC))
                                        .isNotEqualTo(composed));
            }
            assertThat(files.file(composed)).isEqualTo(file);
            Files.delete(file);
        }
    }

    @Test
    void composedFileWinsOverADecomposedOne() throws IOException {
        Files.writeString(folder.resolve("gru\u0308n.txt"), "mac");
        Files.writeString(folder.resolve("grün.txt"), "other");

        assertThat(files.names()).containsExactly("grün");
        assertThat(files.read("gru\u0308n"))
                .hasValueSatisfying(bytes -> assertThat(bytes).asString().isEqualTo("other"));
    }

    @Test
    @Timeout(20)
    void eachListedMotionPlaysAndEachOtherFileHasAReason() throws IOException, InterruptedException {
        for (String name : List.of(
                "nod", "wave 2", "приседание", "a+b", "CON", ".hidden", "blank ", "what?", "50%", "x".repeat(81))) {
            Files.writeString(folder.resolve(name + ".txt"), NOD);
        }
        Files.createDirectory(folder.resolve("folder.txt"));
        Files.createSymbolicLink(folder.resolve("dead.txt"), folder.resolve("nowhere"));
        Files.createSymbolicLink(folder.resolve("random.txt"), Path.of("/dev/urandom"));
        assertThat(new ProcessBuilder("mkfifo", folder.resolve("pipe.txt").toString())
                        .start()
                        .waitFor())
                .isZero();
        try (RandomAccessFile huge =
                new RandomAccessFile(folder.resolve("huge.txt").toFile(), "rw")) {
            huge.setLength(3_000_000_000L);
        }
        MotionLibrary library = MotionFiles.library(folder);

        assertThat(files.names()).containsExactly("a+b", "nod", "wave 2", "приседание");
        for (String name : library.names()) {
            assertThat(library.find(name).map(MotionFile::motion)).as(name).isPresent();
        }
        assertThat(String.join("\n", files.problems()))
                .contains(
                        "CON.txt is the name of a device",
                        ".hidden.txt begins with a dot",
                        "blank .txt ends with a space")
                .contains(
                        "what?.txt contains \"?\"",
                        "50%.txt contains \"%\"",
                        "has 81 characters, more than the 80 allowed")
                .contains("folder.txt is a folder", "dead.txt does not exist", "random.txt is not a regular file")
                .contains("pipe.txt is not a regular file but a device or a pipe", "huge.txt is larger than 2 MB");
        for (String name : List.of("huge", "pipe", "random", "folder")) {
            assertThatExceptionOfType(UnreadableFileException.class)
                    .isThrownBy(() -> library.find(name))
                    .withMessageContaining(name + ".txt");
        }
        assertThat(library.find("dead")).isEmpty();
        assertThat(library.find("../nod")).isEmpty();
    }

    @Test
    void longestNameCanBeSaved() throws IOException {
        String name = "न".repeat(80);

        MotionFiles.save(MotionFile.parse("x", NOD), files.file(name));

        assertThat(files.names()).containsExactly(name);
    }

    @Test
    void saysWhyAMotionCannotHaveAName() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> files.file("a/b"))
                .withMessage("The name \"a/b\" contains \"/\". Choose another name for the motion.");
    }
}
