package org.robonewbie.studio.scene;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import java.util.zip.GZIPOutputStream;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.nao.text.FileName;
import org.robonewbie.simulator.file.RecordingFile;
import org.robonewbie.simulator.file.RecordingRepository;
import org.robonewbie.simulator.file.StateFile;
import org.robonewbie.simulator.recording.RecordingReader;
import org.robonewbie.simulator.state.WorldState;
import org.robonewbie.studio.file.PlainFile;

/**
 * Folder of saved scenes. A scene is a recording of one cycle, so any viewer of recordings can show it.
 *
 * @param folder the folder; it need not exist
 */
record SceneFolder(Path folder) implements SceneStore {

    private static final Pattern NAME = Pattern.compile("[\\p{L}\\p{N}][\\p{L}\\p{N} _.-]{0,59}");
    private static final String REMOVED = ".removed";

    @Override
    public List<String> names() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> PlainFile.isInItsFolder(file) && Files.isRegularFile(file))
                    .map(file -> String.valueOf(file.getFileName()))
                    .filter(name -> name.endsWith(RecordingRepository.ENDING))
                    .map(name -> name.substring(0, name.length() - RecordingRepository.ENDING.length()))
                    .filter(SceneFolder::isName)
                    .sorted()
                    .toList();
        } catch (NoSuchFileException | NotDirectoryException none) {
            return List.of();
        }
    }

    @Override
    public void save(String name, SoccerField field, Checkpoint moment, boolean replace) throws IOException {
        Path file = file(name);
        if (!replace) {
            requireUnused(name);
        }
        Files.createDirectories(folder);
        try {
            try (OutputStream recording = new GZIPOutputStream(AtomicFile.begin(file))) {
                recording.write(SceneRecording.toBytes(field, moment.state()));
            }
            if (moment.exact().isPresent()) {
                try (OutputStream state = AtomicFile.begin(exact(file))) {
                    state.write(moment.exact().get().toBytes());
                }
            }
            replace(file, moment.exact().isPresent());
        } finally {
            Files.deleteIfExists(AtomicFile.part(file));
            Files.deleteIfExists(AtomicFile.part(exact(file)));
        }
    }

    /**
     * Replaces the files in an order that never pairs a scene with the exact state of a different scene, even if the
     * process is killed.
     */
    private static void replace(Path scene, boolean hasState) throws IOException {
        Files.deleteIfExists(exact(scene));
        AtomicFile.moveIntoPlace(scene);
        if (hasState) {
            AtomicFile.moveIntoPlace(exact(scene));
        }
    }

    @Override
    public Removed remove(String name) throws IOException {
        Path kept = removed(name);
        move(file(name), kept, name);
        return () -> {
            requireUnused(name);
            move(kept, file(name), name);
        };
    }

    @Override
    public void rename(String from, String to) throws IOException {
        requireUnused(to);
        move(file(from), file(to), from);
    }

    private void requireUnused(String name) {
        if (Files.exists(file(name))) {
            throw SceneStore.taken(name);
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
            throw SceneStore.gone(name);
        }
    }

    @Override
    public Checkpoint load(String name) throws IOException {
        Path file = file(name);
        try (RecordingReader reader = RecordingFile.read(file)) {
            Checkpoint moment = SceneRecording.moment(reader, 0).orElseThrow(() -> SceneStore.damaged(name));
            return new Checkpoint(moment.before(), moment.state(), exactState(file));
        }
    }

    /**
     * Loads the exact state. If it is missing or has a different version, the scene can still be restored approximately.
     */
    private static Optional<WorldState> exactState(Path scene) throws IOException {
        try {
            return Files.isRegularFile(exact(scene)) ? Optional.of(StateFile.read(exact(scene))) : Optional.empty();
        } catch (IllegalArgumentException unreadable) {
            return Optional.empty();
        }
    }

    /** Returns the file of the exact state, which exists if the scene was saved from a running world. */
    private static Path exact(Path scene) {
        return scene.resolveSibling(scene.getFileName() + StateFile.ENDING);
    }

    /**
     * Returns an unused file name for a deleted scene, because several scenes with the same name can be deleted in
     * succession.
     */
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
                    + "\". Use letters, digits, spaces, dots, - and _, beginning with a letter or digit.");
        }
        Path file = folder.resolve(name + RecordingRepository.ENDING);
        if (Files.exists(file) && !PlainFile.isInItsFolder(file)) {
            throw new IllegalArgumentException(
                    "The scene \"" + name + "\" is a link to a place outside " + folder + ". Choose another one.");
        }
        if (Files.exists(file) && !Files.isRegularFile(file)) {
            throw new IllegalArgumentException(
                    "The scene \"" + name + "\" is not a regular file in " + folder + ". Choose another one.");
        }
        return file;
    }

    private static boolean isName(String name) {
        return NAME.matcher(name).matches() && FileName.isPortable(name);
    }
}
