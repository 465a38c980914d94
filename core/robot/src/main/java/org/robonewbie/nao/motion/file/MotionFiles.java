package org.robonewbie.nao.motion.file;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.text.Normalizer;
import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.nao.file.RegularFile;
import org.robonewbie.nao.motion.JointSpace;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.MotionLibrary;
import org.robonewbie.nao.motion.MotionSource;
import org.robonewbie.nao.text.FileName;

/**
 * A folder of motion files. Static methods load and save single files.
 *
 * <pre>{@code
 * MotionFile wave = MotionFiles.load(Path.of("wave.txt"));
 * MotionFiles.save(wave.withProperty("author", "Ada"), Path.of("wave.txt"));
 * MotionFile stand = MotionFiles.library().find("stand").orElseThrow();
 * }</pre>
 */
public final class MotionFiles implements MotionSource {

    /** Maximum size of a file in bytes, enough for ten thousand keyframes. */
    public static final int MAX_BYTES = 2 << 20;

    private static final String ENDING = ".txt";

    private final Path folder;

    /**
     * Creates a source for the files in a folder.
     *
     * @param folder the folder, which need not exist
     */
    public MotionFiles(Path folder) {
        this.folder = folder;
    }

    /** {@return the user's motions in the folder {@code motions} of the working directory, and the shipped ones} */
    public static MotionLibrary library() {
        return library(Path.of("motions"));
    }

    /**
     * Creates a library with the given folder for the user's motions.
     *
     * @param folder the folder, which need not exist
     * @return the motions in the folder and the shipped ones
     */
    public static MotionLibrary library(Path folder) {
        return new MotionLibrary(new MotionFiles(folder), new ShippedMotions());
    }

    /**
     * Loads a file of the NAO.
     *
     * @param path the file
     * @return the contents of the file; lines that cannot be parsed are kept, see {@link MotionFile#errors}
     * @throws IOException if the file cannot be read, is not a regular file, or is larger than {@link #MAX_BYTES}
     */
    public static MotionFile load(Path path) throws IOException {
        return load(path, JointSpace.NAO);
    }

    /**
     * Loads a file of any robot.
     *
     * @param path the file
     * @param space the joints of the robot
     * @return the contents of the file; lines that cannot be parsed are kept, see {@link MotionFile#errors}
     * @throws IOException if the file cannot be read, is not a regular file, or is larger than {@link #MAX_BYTES}
     */
    public static MotionFile load(Path path, JointSpace space) throws IOException {
        return MotionFile.parse(String.valueOf(path.getFileName()), RegularFile.read(path, MAX_BYTES), space);
    }

    /**
     * Saves a file. An existing file is replaced atomically.
     *
     * @param file the contents to save
     * @param path path of the saved file
     * @throws IOException if the file cannot be written
     */
    public static void save(MotionFile file, Path path) throws IOException {
        AtomicFile.write(path, file.bytes());
    }

    /**
     * Returns the path of a motion's file. Names are compared in Unicode normalization form C, because macOS decomposes
     * letters such as {@code é} in file names.
     *
     * @param name the motion's name without {@code .txt}
     * @return path of the file, which need not exist
     * @throws IllegalArgumentException if no file can have this name; the message says why
     */
    public Path file(String name) {
        String composed = composed(name);
        FileName.problem(composed).ifPresent(problem -> {
            throw new IllegalArgumentException(
                    "The name \"" + name + "\" " + problem + ". Choose another name for the motion.");
        });
        Path usual = folder.resolve(composed + ENDING);
        return Files.exists(usual)
                ? usual
                : entries()
                        .filter(file -> name(file).equals(composed))
                        .findFirst()
                        .orElse(usual);
    }

    @Override
    public Optional<byte[]> read(String name) throws IOException {
        if (FileName.problem(composed(name)).isPresent()) {
            return Optional.empty();
        }
        Path file = file(name);
        return Files.exists(file) ? Optional.of(RegularFile.read(file, MAX_BYTES)) : Optional.empty();
    }

    @Override
    public SortedSet<String> names() {
        return entries()
                .filter(file -> problem(file).isEmpty())
                .map(MotionFiles::name)
                .collect(Collectors.toCollection(TreeSet::new));
    }

    /**
     * Explains why files in the folder are missing from {@link #names}: the name is invalid for a motion, or the file
     * is not a regular file or is larger than {@link #MAX_BYTES}. No file is opened.
     *
     * @return a sentence for each such file, in alphabetical order
     */
    public List<String> problems() {
        return entries().sorted().flatMap(file -> problem(file).stream()).toList();
    }

    private static Optional<String> problem(Path file) {
        Optional<String> wrong = FileName.problem(name(file));
        if (wrong.isPresent()) {
            return Optional.of("The name of the file " + file.getFileName() + " " + wrong.get() + ". Rename it.");
        }
        try {
            RegularFile.check(file, MAX_BYTES);
            return Optional.empty();
        } catch (IOException unreadable) {
            return Optional.of(String.valueOf(unreadable.getMessage()));
        }
    }

    private Stream<Path> entries() {
        if (!Files.isDirectory(folder)) {
            return Stream.empty();
        }
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> String.valueOf(file.getFileName()).endsWith(ENDING)).toList().stream();
        } catch (IOException | UncheckedIOException unreadable) {
            return Stream.empty();
        }
    }

    private static String name(Path file) {
        String name = String.valueOf(file.getFileName());
        return composed(name.substring(0, name.length() - ENDING.length()));
    }

    private static String composed(String name) {
        return Normalizer.normalize(name, Normalizer.Form.NFC);
    }
}
