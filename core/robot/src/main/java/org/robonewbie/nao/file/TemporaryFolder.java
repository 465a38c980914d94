package org.robonewbie.nao.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.stream.Stream;

/**
 * A folder that is deleted with all of its files when it is closed.
 *
 * @param path the folder
 */
public record TemporaryFolder(Path path) implements AutoCloseable {

    /**
     * Creates an empty folder.
     *
     * @param name start of the folder's name
     * @return the folder
     * @throws IOException if the system's folder for temporary files cannot be written to
     */
    public static TemporaryFolder create(String name) throws IOException {
        return new TemporaryFolder(TemporaryFiles.folder(name));
    }

    @Override
    public void close() {
        delete(path);
    }

    /**
     * Deletes a folder with its contents, as far as the system permits.
     *
     * @param folder the folder, which need not exist
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
            // Remaining files do no harm.
        }
    }
}
