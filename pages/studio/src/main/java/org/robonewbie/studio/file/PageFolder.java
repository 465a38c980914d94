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
public abstract class PageFolder implements PageFiles {

    private final Path folder;
    private final int maxBytes;
    private final Optional<PageFolder> drafts;

    /**
     * Provides access to a folder, which need not exist yet.
     *
     * @param folder the folder
     * @param maxBytes maximum size of a file
     * @param drafts the folder for unsaved changes to these files, which are then documents of the user: pages replace only the version
     *     that they have read, and delete none. If it is empty, pages write these files without being asked
     */
    protected PageFolder(Path folder, int maxBytes, Optional<PageFolder> drafts) {
        this.maxBytes = maxBytes;
        this.drafts = drafts;
        this.folder = folder.toAbsolutePath().normalize();
    }

    /** {@return the folder} */
    public Path folder() {
        return folder;
    }

    /** {@return the folder for unsaved changes; empty if these files are not documents of the user} */
    public Optional<PageFolder> drafts() {
        return drafts;
    }

    @Override
    public int maxBytes() {
        return maxBytes;
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
     * {@inheritDoc}
     *
     * @throws UnreadableFileException if it is not a regular file, too large, or unreadable
     */
    @Override
    public Optional<byte[]> read(String path) throws IOException {
        return stored(path);
    }

    private Optional<byte[]> stored(String path) throws IOException {
        Path file = file(path);
        return Files.exists(file) ? Optional.of(RegularFile.read(file, maxBytes)) : Optional.empty();
    }

    @Override
    public synchronized String write(String path, byte[] content, Optional<String> knownVersion) throws IOException {
        String present = stored(path).map(FileVersion::of).orElse("");
        String next = FileVersion.of(content);
        String known = knownVersion.orElse(drafts.isPresent() ? "" : present);
        boolean isGone = present.isEmpty() && drafts.isEmpty();
        if (!present.equals(known) && !present.equals(next) && !isGone) {
            throw new RefusedException(409, conflict(path, known, present));
        }
        overwrite(path, content);
        if (drafts.isPresent()) {
            drafts.get().remove(path, Optional.of(next)); // another window may hold a different draft
        }
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

    private void overwrite(String path, byte[] content) throws IOException {
        Path file = file(path);
        try {
            Files.createDirectories(Objects.requireNonNull(file.getParent()));
        } catch (IOException impossible) {
            throw UnwritableFileException.of(file, impossible);
        }
        AtomicFile.write(file, content);
    }

    @Override
    public synchronized void remove(String path, Optional<String> version) throws IOException {
        if (drafts.isPresent()) {
            PageFiles.super.remove(path, version);
        }
        if (version.isEmpty() || stored(path).map(FileVersion::of).equals(version)) {
            Files.deleteIfExists(file(path));
        }
    }
}
