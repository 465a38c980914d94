package org.robonewbie.studio.motion;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.robonewbie.studio.file.FileVersion;
import org.robonewbie.studio.file.PlainFile;
import org.robonewbie.studio.file.RefusedException;

/**
 * A folder with text files that a page may read and write, and nothing else of this computer. Files are named without folder
 * and extension; they are replaced atomically, so that no reader ever sees one half written.
 */
final class MotionFolder {

    private static final String ENDING = ".txt";
    private static final Pattern NAME = Pattern.compile("[\\p{Alnum}_-][\\p{Alnum}._ -]{0,79}");

    private final Path folder;

    MotionFolder(Path folder) {
        this.folder = folder.toAbsolutePath().normalize();
    }

    /**
     * A file of the folder.
     *
     * @param name its name without ending
     * @param version what its content is known by
     */
    record Entry(String name, String version) {}

    Path folder() {
        return folder;
    }

    /** The files in alphabetical order. */
    List<Entry> list() throws IOException {
        if (!Files.isDirectory(folder)) {
            return List.of();
        }
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(Files::isRegularFile)
                    .map(file -> file.getFileName().toString())
                    .filter(name -> name.endsWith(ENDING))
                    .map(name -> name.substring(0, name.length() - ENDING.length()))
                    .filter(MotionFolder::isName)
                    .sorted()
                    .flatMap(this::entry)
                    .toList();
        }
    }

    private Stream<Entry> entry(String name) {
        try {
            return read(name).map(content -> new Entry(name, FileVersion.of(content))).stream();
        } catch (IOException | RefusedException unreadable) {
            return Stream.empty();
        }
    }

    /** Reads a file; empty if there is none of this name. */
    Optional<byte[]> read(String name) throws IOException {
        try {
            return Optional.of(Files.readAllBytes(checked(name)));
        } catch (NoSuchFileException e) {
            return Optional.empty();
        }
    }

    /**
     * Writes a file, if it is unchanged since the writer last saw it.
     *
     * @param name its name
     * @param content its new content
     * @param knownVersion the version that the writer has seen; empty if the file must not exist yet
     * @return the new version
     * @throws RefusedException if the file has been changed meanwhile
     */
    synchronized String write(String name, byte[] content, String knownVersion) throws IOException {
        Path target = checked(name);
        String present = read(name).map(FileVersion::of).orElse("");
        if (!present.equals(knownVersion)) {
            throw new RefusedException(
                    409,
                    knownVersion.isEmpty()
                            ? "There is a motion \"" + name + "\" already. Choose another name."
                            : "\"" + name + "\" was changed by another program since it was opened here. "
                                    + "Load it again, or save under another name.");
        }
        replace(target, content);
        return FileVersion.of(content);
    }

    /** Writes a file whatever it was before. */
    synchronized void overwrite(String name, byte[] content) throws IOException {
        replace(checked(name), content);
    }

    /** Takes a file away; nothing happens if there is none. */
    synchronized void remove(String name) throws IOException {
        Files.deleteIfExists(checked(name));
    }

    private void replace(Path target, byte[] content) throws IOException {
        Files.createDirectories(folder);
        Path temporary = folder.resolve("." + UUID.randomUUID() + ".tmp");
        try {
            Files.write(temporary, content);
            Files.move(temporary, target, StandardCopyOption.REPLACE_EXISTING, StandardCopyOption.ATOMIC_MOVE);
        } finally {
            Files.deleteIfExists(temporary);
        }
    }

    /** The path of a name; a link must not lead out of the folder either. */
    private Path checked(String name) throws IOException {
        if (!isName(name)) {
            throw new RefusedException(
                    400,
                    "\"" + name
                            + "\" is no name for a motion. Use letters, digits, blanks, dots, - and _, at most 80.");
        }
        Path file = folder.resolve(name + ENDING);
        if (Files.exists(file) && !PlainFile.isInItsFolder(file)) {
            throw new RefusedException(403, "\"" + name + "\" is a link to a place outside of " + folder + ".");
        }
        return file;
    }

    private static boolean isName(String name) {
        return NAME.matcher(name).matches() && PlainFile.isName(name);
    }
}
