package org.robonewbie.simulator.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RecordingLimitTest {

    private static final int FLUSHES = 40;

    @TempDir
    private Path folder;

    private final List<String> said = new ArrayList<>();

    /** Writes bytes that cannot be packed. */
    private void record(String name, int bytesPerFlush, long mostBytes) throws IOException {
        RecordingRepository shelf = new RecordingRepository(folder, mostBytes);
        byte[] noise = new byte[bytesPerFlush];
        Random random = new Random(1);
        RecordingFile file = RecordingFile.open(folder.resolve(name), Optional.of(shelf), said::add);
        for (int i = 0; i < FLUSHES; i++) {
            random.nextBytes(noise);
            file.write(noise, noise.length);
            file.flush();
        }
        file.close();
    }

    @Test
    void oldRecordingMakesRoomWhileARunIsRecorded() throws IOException {
        Path old = Files.write(folder.resolve("old.rec"), new byte[60_000]);
        Files.setLastModifiedTime(old, FileTime.fromMillis(1_000_000));

        record("new.rec", 2_000, 100_000);

        assertThat(old).doesNotExist();
        assertThat(folder.resolve("new.rec")).exists();
        assertThat(said).isEmpty();
    }

    @Test
    void runThatTakesAllTheRoomIsRecordedNoFurther() throws IOException {
        record("long.rec", 10_000, 100_000);

        assertThat(folder.resolve("long.rec")).exists();
        assertThat(Files.size(folder.resolve("long.rec"))).isLessThan(350_000);
        assertThat(said)
                .singleElement()
                .asString()
                .endsWith("ends here because it has reached the size limit for recordings."
                        + " The simulation continues.");
    }
}
