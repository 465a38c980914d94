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
import org.robonewbie.simulator.file.RecordingFile;
import org.robonewbie.simulator.file.RecordingShelf;
import org.robonewbie.simulator.file.StateFile;
import org.robonewbie.simulator.recording.RecordedCycle;
import org.robonewbie.simulator.recording.RecordingReader;
import org.robonewbie.simulator.recording.RecordingWriter;
import org.robonewbie.simulator.state.WorldState;
import org.robonewbie.studio.file.PlainFile;

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
            return files.filter(PlainFile::isInItsFolder)
                    .map(file -> String.valueOf(file.getFileName()))
                    .filter(name -> name.endsWith(RecordingShelf.ENDING))
                    .map(name -> name.substring(0, name.length() - RecordingShelf.ENDING.length()))
                    .filter(SceneFolder::isName)
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
    void save(String name, SoccerField field, WorldSnapshot state, Optional<WorldState> exact, boolean replace)
            throws IOException {
        Path file = file(name);
        if (!replace) {
            refuseTaken(name);
        }
        Files.createDirectories(folder);
        List<String> header = List.of("FieldLength=" + field.length(), "FieldWidth=" + field.width());
        try (RecordingWriter recording = RecordingWriter.open(RecordingFile.open(file, problem -> {}), header)) {
            recording.write(state, List.of());
        }
        Files.deleteIfExists(exact(file));
        if (exact.isPresent()) {
            StateFile.write(exact.get(), exact(file));
        }
    }

    /** Takes a scene away, and returns where it is kept for being brought back. */
    Path remove(String name) throws IOException {
        Path kept = removed(name);
        move(file(name), kept, name);
        return kept;
    }

    /** Restores a scene that was removed. */
    void bringBack(String name, Path kept) throws IOException {
        refuseTaken(name);
        move(kept, file(name), name);
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
            Files.deleteIfExists(exact(to));
            if (Files.exists(exact(from))) {
                Files.move(exact(from), exact(to));
            }
        } catch (NoSuchFileException gone) {
            throw new IllegalArgumentException(
                    "There is no scene \"" + name + "\" any more. Load the page again.", gone);
        }
    }

    KeptMoment load(String name) throws IOException {
        Path file = file(name);
        KeptMoment moment = moment(file, 0)
                .orElseThrow(() -> new IllegalArgumentException("The scene \"" + name + "\" is damaged."));
        return new KeptMoment(moment.before(), moment.state(), exactState(file));
    }

    /** Reads the state to the bit; a scene without, or with one of another version, is still good for a start nearby. */
    private static Optional<WorldState> exactState(Path scene) throws IOException {
        try {
            return Files.exists(exact(scene)) ? Optional.of(StateFile.read(exact(scene))) : Optional.empty();
        } catch (IllegalArgumentException unreadable) {
            return Optional.empty();
        }
    }

    /** Reads a moment of any recording; empty if it has no such moment. */
    static Optional<KeptMoment> moment(Path recording, long index) throws IOException {
        try (RecordingReader reader = RecordingFile.read(recording)) {
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
                    return Optional.of(new KeptMoment(before.orElse(state.get()), state.get(), Optional.empty()));
                }
            }
            return Optional.empty();
        }
    }

    /** Scenes that were saved from a living world have the world's state to the bit beside them. */
    private static Path exact(Path scene) {
        return scene.resolveSibling(scene.getFileName() + StateFile.ENDING);
    }

    /** Several scenes of one name can be removed, one after the other. */
    private Path removed(String name) {
        Path first = file(name).resolveSibling(name + REMOVED);
        Path kept = first;
        for (int copy = 2; Files.exists(kept); copy++) {
            kept = first.resolveSibling(name + " " + copy + REMOVED);
        }
        return kept;
    }

    private Path file(String name) {
        if (!isName(name)) {
            throw new IllegalArgumentException("A scene cannot be named \"" + name
                    + "\". Use letters, digits, blanks, dots, - and _, beginning with a letter or digit.");
        }
        Path file = folder.resolve(name + RecordingShelf.ENDING);
        if (Files.exists(file) && !PlainFile.isInItsFolder(file)) {
            throw new IllegalArgumentException(
                    "The scene \"" + name + "\" is a link to a place outside of " + folder + ". Choose another one.");
        }
        return file;
    }

    private static boolean isName(String name) {
        return NAME.matcher(name).matches() && PlainFile.isName(name);
    }
}
