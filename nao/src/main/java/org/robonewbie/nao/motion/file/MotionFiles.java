package org.robonewbie.nao.motion.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.UUID;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.MotionLibrary;
import org.robonewbie.nao.motion.MotionSource;

/**
 * The motion files of a folder; also loads and saves single files.
 *
 * <pre>{@code
 * MotionFile wave = MotionFiles.load(Path.of("wave.txt"));
 * MotionFiles.save(wave.withProperty("author", "Ada"), Path.of("wave.txt"));
 * MotionFile stand = MotionFiles.library().find("stand").orElseThrow();
 * }</pre>
 */
public final class MotionFiles implements MotionSource {

    private static final String ENDING = ".txt";

    private final Path folder;

    /**
     * Opens a folder.
     *
     * @param folder the folder, which need not exist
     */
    public MotionFiles(Path folder) {
        this.folder = folder;
    }

    /** {@return the motions that a robot can perform: those in {@code motions} below the working directory, and the shipped ones} */
    public static MotionLibrary library() {
        return library(Path.of("motions"));
    }

    /**
     * Opens a library with another folder for the user's motions.
     *
     * @param folder the folder, which need not exist
     * @return its motions and the shipped ones
     */
    public static MotionLibrary library(Path folder) {
        return new MotionLibrary(new MotionFiles(folder), new ShippedMotions());
    }

    /**
     * Loads a file.
     *
     * @param path the file
     * @return its content; lines that cannot be understood are kept, see {@link MotionFile#errors}
     * @throws IOException if the file cannot be read
     */
    public static MotionFile load(Path path) throws IOException {
        return MotionFile.parse(String.valueOf(path.getFileName()), Files.readAllBytes(path));
    }

    /**
     * Saves a file. It is replaced as a whole, so that a reader never sees half of it.
     *
     * @param file the content
     * @param path where to save it
     * @throws IOException if the file cannot be written
     */
    public static void save(MotionFile file, Path path) throws IOException {
        Path target = path.toAbsolutePath();
        Path temporary = target.resolveSibling(target.getFileName() + "." + UUID.randomUUID() + ".tmp");
        try {
            Files.write(temporary, file.bytes());
            Files.move(temporary, target, StandardCopyOption.REPLACE_EXISTING, StandardCopyOption.ATOMIC_MOVE);
        } finally {
            Files.deleteIfExists(temporary);
        }
    }

    @Override
    public Optional<byte[]> read(String name) throws IOException {
        Path file = folder.resolve(name + ENDING);
        return Files.isRegularFile(file) ? Optional.of(Files.readAllBytes(file)) : Optional.empty();
    }

    @Override
    public SortedSet<String> names() {
        if (!Files.isDirectory(folder)) {
            return new TreeSet<>();
        }
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> String.valueOf(file.getFileName()))
                    .filter(name -> name.endsWith(ENDING))
                    .map(name -> name.substring(0, name.length() - ENDING.length()))
                    .collect(Collectors.toCollection(TreeSet::new));
        } catch (IOException unreadable) {
            return new TreeSet<>();
        }
    }
}
