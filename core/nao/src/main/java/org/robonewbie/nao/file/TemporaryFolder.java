package org.robonewbie.nao.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.stream.Stream;

/**
 * A folder that is gone with all of its files when it is closed.
 *
 * @param path the folder
 */
public record TemporaryFolder(Path path) implements AutoCloseable {

    /**
     * Makes an empty folder.
     *
     * @param name how its name begins
     * @return the folder
     * @throws IOException if the system's folder for temporary files cannot be written
     */
    public static TemporaryFolder create(String name) throws IOException {
        return new TemporaryFolder(TemporaryFiles.folder(name));
    }

    @Override
    public void close() {
        delete(path);
    }

    /**
     * Deletes a folder with everything in it, where the system permits it.
     *
     * @param folder the folder; it need not exist
     */
    public static void delete(Path folder) {
        if (!Files.exists(folder)) {
            return;
        }
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.deleteIfExists(file);
            }
        } catch (IOException inUse) {
            // What is left does no harm.
        }
    }
}
