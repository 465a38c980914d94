package org.robonewbie.studio.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.nao.file.RegularFile;
import org.robonewbie.nao.file.UnreadableFileException;
import org.robonewbie.nao.file.UnwritableFileException;

/**
 * Folder of files of one kind that pages may read and write; pages cannot access files outside it. Writes are atomic,
 * so no reader sees a partial file.
 */
public abstract class PageFolder {

    private final Path folder;
    private final int maxBytes;

    /**
     * Provides access to a folder, which need not exist yet.
     *
     * @param folder the folder
     * @param maxBytes maximum size of a file to read
     */
    protected PageFolder(Path folder, int maxBytes) {
        this.maxBytes = maxBytes;
        this.folder = folder.toAbsolutePath().normalize();
    }

    /**
     * A file in the folder.
     *
     * @param path its path as used by pages
     * @param version its {@link FileVersion}
     */
    public record Entry(String path, String version) {}

    /** {@return the folder} */
    public Path folder() {
        return folder;
    }

    /**
     * Resolves a path as used by pages. Symbolic links that lead out of the folder are refused.
     *
     * @param path path as used by pages
     * @return the file, which need not exist
     * @throws RefusedException if the path is not allowed
     * @throws IOException if the path cannot be resolved
     */
    public abstract Path file(String path) throws IOException;

    /** {@return the noun for the files in this folder in messages, such as "motion"} */
    protected abstract String kind();

    /**
     * Lists files, omitting unreadable ones.
     *
     * @param paths paths as used by pages
     * @return one entry per readable file
     */
    protected List<Entry> entries(Stream<String> paths) {
        return paths.flatMap(this::entry).toList();
    }

    private Stream<Entry> entry(String path) {
        try {
            return read(path).map(content -> new Entry(path, FileVersion.of(content))).stream();
        } catch (IOException | RefusedException unreadable) {
            return Stream.empty();
        }
    }

    /**
     * Reads a file.
     *
     * @param path path as used by pages
     * @return the contents; empty if there is no such file
     * @throws UnreadableFileException if it is not a regular file, too large, or unreadable
     * @throws IOException if the path cannot be resolved
     */
    public Optional<byte[]> read(String path) throws IOException {
        Path file = file(path);
        return Files.exists(file) ? Optional.of(RegularFile.read(file, maxBytes)) : Optional.empty();
    }

    /**
     * Writes a file if it has not changed since the writer last read it, or if it already has these contents.
     *
     * @param path path as used by pages
     * @param content the new contents
     * @param knownVersion the version that the writer has read; empty if the file must not exist yet
     * @return the new version
     * @throws RefusedException if the file has changed since then
     * @throws IOException if it cannot be written
     */
    public synchronized String write(String path, byte[] content, String knownVersion) throws IOException {
        String present = read(path).map(FileVersion::of).orElse("");
        String next = FileVersion.of(content);
        if (!present.equals(knownVersion) && !present.equals(next)) {
            throw new RefusedException(409, conflict(path, knownVersion, present));
        }
        overwrite(path, content);
        return next;
    }

    private String conflict(String path, String knownVersion, String present) {
        String file = "\"" + path + "\"";
        if (knownVersion.isEmpty()) {
            return "There is already a " + kind() + " named " + file + ". Choose another name.";
        }
        return present.isEmpty()
                ? file
                        + " was deleted by another program after it was opened here. Keep it open, or save it under another name."
                : file
                        + " was changed by another program after it was opened here. Reload it, or save it under another name.";
    }

    /**
     * Writes a file unless it has changed since the writer last read it. A deleted file is written again.
     *
     * @param path path as used by pages
     * @param content the new contents
     * @param knownVersion the version that the writer has read; empty if it has read none
     * @return the new version
     * @throws RefusedException if the file has changed since then
     * @throws IOException if it cannot be written
     */
    public synchronized String writeIfKnown(String path, byte[] content, String knownVersion) throws IOException {
        return write(path, content, read(path).isPresent() ? knownVersion : "");
    }

    /**
     * Writes a file regardless of its previous contents.
     *
     * @param path path as used by pages
     * @param content the new contents
     * @throws IOException if it cannot be written
     */
    public synchronized void overwrite(String path, byte[] content) throws IOException {
        Path file = file(path);
        try {
            Files.createDirectories(Objects.requireNonNull(file.getParent()));
        } catch (IOException impossible) {
            throw UnwritableFileException.of(file, impossible);
        }
        AtomicFile.write(file, content);
    }

    /**
     * Deletes a file if it exists.
     *
     * @param path path as used by pages
     * @throws IOException if it cannot be deleted
     */
    public synchronized void remove(String path) throws IOException {
        Files.deleteIfExists(file(path));
    }

    /**
     * Deletes a file if it has the given version.
     *
     * @param path path as used by pages
     * @param version the version; a file with a different version is kept
     * @throws IOException if it cannot be deleted
     */
    public synchronized void remove(String path, String version) throws IOException {
        if (read(path).map(FileVersion::of).filter(version::equals).isPresent()) {
            remove(path);
        }
    }
}
