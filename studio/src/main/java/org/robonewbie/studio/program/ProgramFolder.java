package org.robonewbie.studio.program;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.studio.file.FileVersion;
import org.robonewbie.studio.file.PlainFile;
import org.robonewbie.studio.file.RefusedException;

/**
 * The Java files of a folder that a page may read and write, and nothing else of this computer: those that lie in it, and those of
 * a project's {@code src/main/java}. They are known by their path from the folder on, with slashes.
 */
final class ProgramFolder {

    private static final String ENDING = ".java";
    private static final String SOURCES = "src/main/java";
    private static final int MOST_FILES = 500;
    private static final int DEEPEST = 12;
    private static final Pattern PATH = Pattern.compile(
            "(?:[\\p{L}_][\\p{L}\\p{N}_-]{0,79}/){0," + DEEPEST + "}[\\p{L}_$][\\p{L}\\p{N}_$]{0,79}\\.java");

    private final Path folder;

    ProgramFolder(Path folder) {
        this.folder = folder.toAbsolutePath().normalize();
    }

    /**
     * A file of the folder.
     *
     * @param path from the folder on
     * @param version what its content is known by
     */
    record Entry(String path, String version) {}

    Path folder() {
        return folder;
    }

    /** The files in alphabetical order, those of the folder itself first. */
    List<Entry> list() throws IOException {
        return Stream.concat(paths(folder, 1).stream(), paths(folder.resolve(SOURCES), DEEPEST).stream())
                .flatMap(this::entry)
                .toList();
    }

    /** All files below the folder, wherever they are. */
    List<Entry> listAll() throws IOException {
        return paths(folder, DEEPEST + 1).stream().flatMap(this::entry).toList();
    }

    private List<String> paths(Path start, int depth) throws IOException {
        if (!Files.isDirectory(start)) {
            return List.of();
        }
        try (Stream<Path> files = Files.walk(start, depth)) {
            return files.filter(file -> file.toString().endsWith(ENDING))
                    .filter(Files::isRegularFile)
                    .map(file -> folder.relativize(file).toString().replace('\\', '/'))
                    .filter(path -> PATH.matcher(path).matches())
                    .sorted()
                    .limit(MOST_FILES)
                    .toList();
        }
    }

    private Stream<Entry> entry(String path) {
        try {
            return read(path).map(content -> new Entry(path, FileVersion.of(content))).stream();
        } catch (IOException | RefusedException unreadable) {
            return Stream.empty();
        }
    }

    /** Reads a file; empty if there is none. */
    Optional<byte[]> read(String path) throws IOException {
        try {
            return Optional.of(Files.readAllBytes(file(path)));
        } catch (NoSuchFileException none) {
            return Optional.empty();
        }
    }

    /**
     * Writes a file, if it is unchanged since the writer last saw it.
     *
     * @param path from the folder on
     * @param content its new content
     * @param knownVersion the version that the writer has seen; empty if the file must not exist yet
     * @return the new version
     * @throws RefusedException if the file has been changed meanwhile
     */
    synchronized String write(String path, byte[] content, String knownVersion) throws IOException {
        String present = read(path).map(FileVersion::of).orElse("");
        if (!present.equals(knownVersion) && !present.equals(FileVersion.of(content))) {
            throw new RefusedException(
                    409,
                    knownVersion.isEmpty()
                            ? "There is a file \"" + path + "\" already. Choose another name."
                            : "\"" + path + "\" was changed by another program since it was opened here.");
        }
        overwrite(path, content);
        return FileVersion.of(content);
    }

    /** Writes a file whatever it was before. */
    synchronized void overwrite(String path, byte[] content) throws IOException {
        Path file = file(path);
        Files.createDirectories(Objects.requireNonNull(file.getParent()));
        AtomicFile.write(file, new String(content, StandardCharsets.UTF_8));
    }

    /** Takes a file away; nothing happens if there is none. */
    synchronized void remove(String path) throws IOException {
        Files.deleteIfExists(file(path));
    }

    /** The file of a path; a link must not lead out of the folder either. */
    Path file(String path) throws IOException {
        boolean isPlain = Arrays.stream(path.split("/")).allMatch(PlainFile::isName);
        if (!isPlain || !PATH.matcher(path).matches()) {
            throw new RefusedException(
                    400, "\"" + path + "\" is no name for a program. Use letters, digits and _, such as MyAgent.java.");
        }
        Path file = folder.resolve(path);
        for (Path each = file; !each.equals(folder); each = Objects.requireNonNull(each.getParent())) {
            if (Files.exists(each) && !each.toRealPath().startsWith(folder.toRealPath())) {
                throw new RefusedException(403, "\"" + path + "\" is a link to a place outside of " + folder + ".");
            }
        }
        return file;
    }
}
