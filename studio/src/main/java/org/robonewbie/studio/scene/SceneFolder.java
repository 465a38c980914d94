package org.robonewbie.studio.scene;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.recording.RecordedCycle;
import org.robonewbie.simulator.recording.RecordingReader;
import org.robonewbie.simulator.recording.RecordingShelf;
import org.robonewbie.simulator.recording.SnapshotRecording;

/**
 * The folder of saved scenes. A scene is a recording of one cycle, so whatever shows recordings shows it too.
 *
 * @param folder where the files are; it need not exist
 */
record SceneFolder(Path folder) {

    private static final Pattern NAME = Pattern.compile("[\\p{L}\\p{N}][\\p{L}\\p{N} _.-]{0,59}");
    private static final String REMOVED = ".removed";
    private static final int FRAMES_FOR_VELOCITY = 2;

    List<String> names() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> String.valueOf(file.getFileName()))
                    .filter(name -> name.endsWith(RecordingShelf.ENDING))
                    .map(name -> name.substring(0, name.length() - RecordingShelf.ENDING.length()))
                    .sorted()
                    .toList();
        } catch (NoSuchFileException | NotDirectoryException none) {
            return List.of();
        }
    }

    /**
     * Saves a scene.
     *
     * @throws IllegalArgumentException if the name cannot be a file's name or is taken; the message says so
     */
    void save(String name, SoccerField field, WorldSnapshot state, boolean replace) throws IOException {
        Path file = file(name);
        if (!replace) {
            refuseTaken(name);
        }
        Files.createDirectories(folder);
        List<String> header = List.of("FieldLength=" + field.length(), "FieldWidth=" + field.width());
        try (SnapshotRecording recording = SnapshotRecording.open(file, header, problem -> {})) {
            recording.write(state, List.of());
        }
    }

    /** Takes a scene away; until the next scene of that name is taken away it can be brought back. */
    void remove(String name) throws IOException {
        move(file(name), removed(name), name);
    }

    /** Brings back what was taken away. */
    void bringBack(String name) throws IOException {
        refuseTaken(name);
        move(removed(name), file(name), name);
    }

    void rename(String from, String to) throws IOException {
        refuseTaken(to);
        move(file(from), file(to), from);
    }

    private void refuseTaken(String name) {
        if (Files.exists(file(name))) {
            throw new IllegalArgumentException("There is a scene \"" + name + "\" already. Choose another name.");
        }
    }

    private static void move(Path from, Path to, String name) throws IOException {
        try {
            Files.move(from, to, StandardCopyOption.REPLACE_EXISTING);
        } catch (NoSuchFileException gone) {
            throw new IllegalArgumentException(
                    "There is no scene \"" + name + "\" any more. Load the page again.", gone);
        }
    }

    KeptMoment load(String name) throws IOException {
        return moment(file(name), 0)
                .orElseThrow(() -> new IllegalArgumentException("The scene \"" + name + "\" is damaged."));
    }

    /** Reads a moment of any recording; empty if it has no such moment. */
    static Optional<KeptMoment> moment(Path recording, long index) throws IOException {
        try (RecordingReader reader = RecordingReader.open(recording)) {
            Optional<WorldSnapshot> before = Optional.empty();
            for (long i = 0; i <= index; i++) {
                Optional<WorldSnapshot> state = reader.next().map(RecordedCycle::snapshot);
                if (state.isEmpty()) {
                    return Optional.empty();
                }
                if (i == Math.max(0, index - FRAMES_FOR_VELOCITY)) {
                    before = state;
                }
                if (i == index) {
                    return Optional.of(new KeptMoment(before.orElse(state.get()), state.get()));
                }
            }
            return Optional.empty();
        }
    }

    private Path removed(String name) {
        return file(name).resolveSibling(name + REMOVED);
    }

    private Path file(String name) {
        if (!NAME.matcher(name).matches()) {
            throw new IllegalArgumentException("A scene cannot be named \"" + name
                    + "\". Use letters, digits, blanks, dots, - and _, beginning with a letter or digit.");
        }
        return folder.resolve(name + RecordingShelf.ENDING);
    }
}
