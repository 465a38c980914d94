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
 * The folder of saved scenes. A scene is a recording of one cycle, so whatever shows recordings shows it too.
 *
 * @param folder where the files are; it need not exist
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
            refuseTaken(name);
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

    /** Whenever this process is killed, no scene has the exact state of another one. */
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
            refuseTaken(name);
            move(kept, file(name), name);
        };
    }

    @Override
    public void rename(String from, String to) throws IOException {
        refuseTaken(to);
        move(file(from), file(to), from);
    }

    private void refuseTaken(String name) {
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

    /** Reads the state to the bit; a scene without, or with one of another version, is still good for a start nearby. */
    private static Optional<WorldState> exactState(Path scene) throws IOException {
        try {
            return Files.isRegularFile(exact(scene)) ? Optional.of(StateFile.read(exact(scene))) : Optional.empty();
        } catch (IllegalArgumentException unreadable) {
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
        Path file = folder.resolve(name + RecordingRepository.ENDING);
        if (Files.exists(file) && !PlainFile.isInItsFolder(file)) {
            throw new IllegalArgumentException(
                    "The scene \"" + name + "\" is a link to a place outside of " + folder + ". Choose another one.");
        }
        if (Files.exists(file) && !Files.isRegularFile(file)) {
            throw new IllegalArgumentException(
                    "The scene \"" + name + "\" is no regular file in " + folder + ". Choose another one.");
        }
        return file;
    }

    private static boolean isName(String name) {
        return NAME.matcher(name).matches() && FileName.isPortable(name);
    }
}
