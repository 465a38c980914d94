package org.robonewbie.studio.scene;

import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;
import java.util.zip.ZipException;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.simulator.file.RecordingRepository;
import org.robonewbie.simulator.file.StateFile;
import org.robonewbie.studio.file.PlainFile;

/**
 * Folder of saved scenes.
 *
 * @param folder the folder; it need not exist
 */
record SceneFolder(Path folder) implements SceneStore {

    @Override
    public List<String> names() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(SceneFolder::isPlain)
                    .map(file -> String.valueOf(file.getFileName()))
                    .filter(name -> name.endsWith(RecordingRepository.ENDING))
                    .map(name -> name.substring(0, name.length() - RecordingRepository.ENDING.length()))
                    .filter(SceneService::isName)
                    .sorted()
                    .toList();
        } catch (NoSuchFileException | NotDirectoryException none) {
            return List.of();
        }
    }

    private static boolean isPlain(Path file) {
        return PlainFile.isInItsFolder(file) && Files.isRegularFile(file);
    }

    @Override
    public SavedScene read(String name) throws IOException {
        Path file = file(name);
        return new SavedScene(
                unpacked(file), Files.exists(exact(file)) ? Files.readAllBytes(exact(file)) : new byte[0]);
    }

    /** Decompresses a file as far as it is readable. */
    private static byte[] unpacked(Path file) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (InputStream in = new GZIPInputStream(Files.newInputStream(file))) {
            in.transferTo(bytes);
        } catch (EOFException | ZipException endOfWhatIsGood) {
            return bytes.toByteArray();
        }
        return bytes.toByteArray();
    }

    @Override
    public void write(String name, SavedScene scene) throws IOException {
        Path file = file(name);
        if (Files.exists(file) && !isPlain(file)) {
            throw new IllegalArgumentException(
                    "The scene \"" + name + "\" is a link or folder in " + folder + ". Choose another name.");
        }
        Files.createDirectories(folder);
        try {
            try (OutputStream recording = new GZIPOutputStream(AtomicFile.begin(file))) {
                recording.write(scene.recording());
            }
            try (OutputStream state = AtomicFile.begin(exact(file))) {
                state.write(scene.exact());
            }
            replace(file, scene.exact().length > 0);
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
    public void delete(String name) throws IOException {
        Files.deleteIfExists(exact(file(name)));
        Files.deleteIfExists(file(name));
    }

    private Path file(String name) {
        return folder.resolve(name + RecordingRepository.ENDING);
    }

    /** Returns the file with the exact state, which exists if the scene was saved from a running world. */
    private static Path exact(Path scene) {
        return scene.resolveSibling(scene.getFileName() + StateFile.ENDING);
    }
}
