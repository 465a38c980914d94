package org.robonewbie.simulator.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RecordingRepositoryTest {

    @TempDir
    private Path folder;

    private Path recording(String name, int bytes, long modifiedMillis) throws IOException {
        Path file = Files.write(folder.resolve(name), new byte[bytes]);
        return Files.setLastModifiedTime(file, FileTime.fromMillis(modifiedMillis));
    }

    @Test
    void oldestRecordingsMakeRoomForTheNext() throws IOException {
        Path old = recording("old.rec", 400, 1000);
        Path newer = recording("newer.rec.part", 400, 2000);
        Path newest = recording("newest.rec", 400, 3000);
        Path other = recording("notes.txt", 5000, 0);

        Path next = new RecordingRepository(folder, 1000).next("Ada").orElseThrow();

        assertThat(old).doesNotExist();
        assertThat(newer).exists();
        assertThat(newest).exists();
        assertThat(other).exists();
        assertThat(next).doesNotExist();
        assertThat(next.getParent()).isEqualTo(folder);
        assertThat(next.toString()).endsWith(".rec");
    }

    @Test
    void recordingWithAStarStaysAndWhatLiesBesideTheOthersGoesWithThem() throws IOException {
        Path kept = recording("kept.rec", 900, 1000);
        RecordingAbout.NOTHING.withStar(true).write(kept);
        Path old = recording("old.rec", 400, 2000);
        Path notes = Files.createFile(folder.resolve("old.notes"));
        Path index = Files.createFile(folder.resolve("old.index"));
        recording("newer.rec", 400, 3000);
        recording("newest.rec", 400, 4000);

        Path next = new RecordingRepository(folder, 1000).next("Agent_Wave").orElseThrow();

        assertThat(kept).exists();
        assertThat(old).doesNotExist();
        assertThat(notes).doesNotExist();
        assertThat(index).doesNotExist();
        assertThat(RecordingAbout.of(next).agent()).isEqualTo("Agent_Wave");
        assertThat(RecordingAbout.of(next).project())
                .isEqualTo(Path.of("").toAbsolutePath().toString());
    }

    @Test
    void recordingsOfTheSameSecondHaveDifferentNames() throws IOException {
        RecordingRepository shelf = new RecordingRepository(folder, 1000);
        Path first = Files.createFile(shelf.next("Ada").orElseThrow());

        assertThat(shelf.next("Ada").orElseThrow()).isNotEqualTo(first);
    }

    @Test
    void newestIsListedFirst() throws IOException {
        Path old = recording("old.rec", 4, 1000);
        Path newer = recording("newer.rec.part", 4, 2000);

        assertThat(new RecordingRepository(folder, 1000).list()).containsExactly(newer, old);
    }

    @Test
    void folderThatCannotBeMadeMeansNoRecording() throws IOException {
        Path file = Files.createFile(folder.resolve("file"));

        assertThat(new RecordingRepository(file.resolve("below"), 1000).next("Ada"))
                .isEmpty();
    }
}
