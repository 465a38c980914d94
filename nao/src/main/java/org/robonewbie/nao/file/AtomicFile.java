package org.robonewbie.nao.file;

import java.io.IOException;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;

/**
 * Files that appear under their name as a whole or not at all. While they are written they are called {@code NAME.part}, so a
 * program that is killed leaves the former file as it was.
 *
 * <pre>{@code
 * AtomicFile.write(Path.of("report.json"), report.toJson());
 * }</pre>
 */
public final class AtomicFile {

    /** How the names of files end that are not finished. */
    public static final String UNFINISHED = ".part";

    private AtomicFile() {}

    /**
     * Writes a text in UTF-8; a file of the same name is replaced.
     *
     * @param file the file
     * @param text all of its text
     * @throws IOException if the file cannot be written
     */
    public static void write(Path file, String text) throws IOException {
        Files.writeString(part(file), text);
        moveIntoPlace(file);
    }

    /**
     * Names a file that is still being written.
     *
     * @param file its name when it is finished
     * @return its name until then
     */
    public static Path part(Path file) {
        return file.resolveSibling(file.getFileName() + UNFINISHED);
    }

    /**
     * Gives a file its name when all of it has been written to {@link #part}; a file of the same name is replaced.
     *
     * @param file the file
     * @throws IOException if it cannot be moved
     */
    public static void moveIntoPlace(Path file) throws IOException {
        try {
            Files.move(part(file), file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        } catch (AtomicMoveNotSupportedException e) {
            Files.move(part(file), file, StandardCopyOption.REPLACE_EXISTING);
        }
    }
}
