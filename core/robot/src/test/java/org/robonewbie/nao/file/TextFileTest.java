package org.robonewbie.nao.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

class TextFileTest {

    @TempDir
    Path folder;

    @Test
    void readsAFileWithAByteOrderMark() throws IOException {
        Path file = Files.writeString(folder.resolve("team.properties"), "\uFEFFteam = Größe");

        assertThat(TextFile.read(file).content()).isEqualTo("team = Größe");
    }

    @Test
    void namesFileAndLineOfWhatIsNoText() throws IOException {
        Path file = Files.write(folder.resolve("a.txt"), new byte[] {'a', '\n', 0});

        refuses(file, "The file " + file + " cannot be read: line 2 contains a zero byte");
    }

    @Test
    void saysWhatIsWrongWithAPath() throws IOException {
        refuses(folder.resolve("none.txt"), "does not exist. Check the name.");
        refuses(
                Path.of("none.txt"),
                "does not exist in the folder " + Path.of("").toAbsolutePath());
        refuses(Files.createDirectory(folder.resolve("a-folder")), "is a folder");
    }

    @Test
    void refusesAHugeFileWithoutReadingIt() throws IOException {
        Path file = folder.resolve("huge.txt");
        try (RandomAccessFile huge = new RandomAccessFile(file.toFile(), "rw")) {
            huge.setLength(3L << 30);
        }

        refuses(file, "is larger than 16 MB");
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void opensNoDevice() throws IOException {
        Path link = Files.createSymbolicLink(folder.resolve("zero.txt"), Path.of("/dev/zero"));

        refuses(link, "is not a regular file but a device or a pipe");
    }

    @Test
    void readsExactlyTheLargestFile() throws IOException {
        Path file = Files.writeString(folder.resolve("four.bin"), "1234", StandardCharsets.US_ASCII);

        assertThat(RegularFile.read(file, 4)).hasSize(4);
        assertThatExceptionOfType(UnreadableFileException.class).isThrownBy(() -> RegularFile.read(file, 3));
    }

    private static void refuses(Path file, String problem) {
        assertThatExceptionOfType(UnreadableFileException.class)
                .isThrownBy(() -> TextFile.read(file))
                .withMessageContaining(problem);
    }
}
