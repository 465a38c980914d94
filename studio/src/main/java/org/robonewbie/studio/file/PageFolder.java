package org.robonewbie.studio.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.UUID;
import java.util.stream.Stream;
import org.robonewbie.nao.file.RegularFile;

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
     * @throws IOException if it cannot be read, is no regular file, or too large
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
            throw new RefusedException(
                    409,
                    knownVersion.isEmpty()
                            ? "There is a " + kind() + " \"" + path + "\" already. Choose another name."
                            : "\"" + path + "\" was changed by another program since it was opened here. "
                                    + "Load it again, or save under another name.");
        }
        overwrite(path, content);
        return next;
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
        Path place = Objects.requireNonNull(file.getParent());
        Files.createDirectories(place);
        Path unfinished = place.resolve("." + UUID.randomUUID() + ".tmp");
        try {
            Files.write(unfinished, content);
            Files.move(unfinished, file, StandardCopyOption.REPLACE_EXISTING, StandardCopyOption.ATOMIC_MOVE);
        } finally {
            Files.deleteIfExists(unfinished);
        }
    }

    /**
     * Takes a file away; nothing happens if there is none.
     *
     * @param path what pages call it
     * @throws IOException if it cannot be taken away
     */
    public synchronized void remove(String path) throws IOException {
        Files.deleteIfExists(file(path));
    }
}
