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
 * A folder with files of one kind that pages may read and write, and nothing else of this computer. Files are replaced
 * atomically, so that no reader ever sees one half written.
 */
public abstract class PageFolder {

    private final Path folder;
    private final int maxBytes;

    /**
     * Opens a folder, which need not exist yet.
     *
     * @param folder the folder
     * @param maxBytes the largest file that is read
     */
    protected PageFolder(Path folder, int maxBytes) {
        this.maxBytes = maxBytes;
        this.folder = folder.toAbsolutePath().normalize();
    }

    /**
     * A file of the folder.
     *
     * @param path what pages call it
     * @param version what its content is known by
     */
    public record Entry(String path, String version) {}

    /** {@return the folder} */
    public Path folder() {
        return folder;
    }

    /**
     * Finds the file that pages call so. A link must not lead out of the folder either.
     *
     * @param path what pages call it
     * @return the file, which need not exist
     * @throws RefusedException if a page must not reach it
     * @throws IOException if its place cannot be looked up
     */
    public abstract Path file(String path) throws IOException;

    /** {@return what a file of this folder is called in messages, such as "motion"} */
    protected abstract String kind();

    /**
     * Describes files; those that cannot be read are left out.
     *
     * @param paths what pages call them
     * @return one entry for each
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
     * @param path what pages call it
     * @return its content; empty if there is no such file
     * @throws UnreadableFileException if it is no regular file, too large, or cannot be read
     * @throws IOException if its place cannot be looked up
     */
    public Optional<byte[]> read(String path) throws IOException {
        Path file = file(path);
        return Files.exists(file) ? Optional.of(RegularFile.read(file, maxBytes)) : Optional.empty();
    }

    /**
     * Writes a file, if it is unchanged since the writer last saw it or has this content already.
     *
     * @param path what pages call it
     * @param content its new content
     * @param knownVersion the version that the writer has seen; empty if the file must not exist yet
     * @return the new version
     * @throws RefusedException if the file has been changed meanwhile
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
            return "There is a " + kind() + " " + file + " already. Choose another name.";
        }
        return present.isEmpty()
                ? file
                        + " was deleted by another program since it was opened here. Keep what is here, or save it under another name."
                : file
                        + " was changed by another program since it was opened here. Load it again, or save under another name.";
    }

    /**
     * Writes a file, unless it has become another one than the writer knows; one that is gone meanwhile is written again.
     *
     * @param path what pages call it
     * @param content its new content
     * @param knownVersion the version that the writer has seen; empty if it has seen none
     * @return the new version
     * @throws RefusedException if the file has been changed meanwhile
     * @throws IOException if it cannot be written
     */
    public synchronized String writeIfKnown(String path, byte[] content, String knownVersion) throws IOException {
        return write(path, content, read(path).isPresent() ? knownVersion : "");
    }

    /**
     * Writes a file whatever it was before.
     *
     * @param path what pages call it
     * @param content its new content
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
     * Deletes a file; nothing happens if there is none.
     *
     * @param path what pages call it
     * @throws IOException if it cannot be deleted
     */
    public synchronized void remove(String path) throws IOException {
        Files.deleteIfExists(file(path));
    }

    /**
     * Deletes a file of which only this version is not needed any more.
     *
     * @param path what pages call it
     * @param version the version; nothing happens if the file has another one, or if there is none
     * @throws IOException if it cannot be deleted
     */
    public synchronized void remove(String path, String version) throws IOException {
        if (read(path).map(FileVersion::of).filter(version::equals).isPresent()) {
            remove(path);
        }
    }
}
