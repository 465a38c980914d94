package org.robonewbie.nao.motion.file;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.MotionSource;

/**
 * The motions that come with the framework: resources {@code /motions/NAME.txt} of the class path. Their names are kept in the
 * resource {@code /motions/index}, one on each line, since not every class path can list its resources.
 */
public final class ShippedMotions implements MotionSource {

    private static final String FOLDER = "/motions/";

    /** Opens the shipped motions. */
    public ShippedMotions() {}

    /**
     * Loads a motion.
     *
     * @param name its name, such as {@code walk-forward}
     * @return the motion
     * @throws IllegalArgumentException if none of the shipped motions has this name
     */
    public static Motion motion(String name) {
        return file(name).motion();
    }

    /**
     * Loads a motion with the comments of its file.
     *
     * @param name its name, such as {@code walk-forward}
     * @return the file
     * @throws IllegalArgumentException if none of the shipped motions has this name
     */
    public static MotionFile file(String name) {
        return resource(name + ".txt")
                .map(bytes -> MotionFile.parse(name + ".txt", bytes))
                .orElseThrow(() -> new IllegalArgumentException("There is no shipped motion \"" + name + "\"."));
    }

    @Override
    public Optional<byte[]> read(String name) {
        return resource(name + ".txt");
    }

    @Override
    public SortedSet<String> names() {
        String index = new String(resource("index").orElseThrow(), StandardCharsets.UTF_8);
        return new TreeSet<>(List.of(index.split("\\s+")));
    }

    private static Optional<byte[]> resource(String file) {
        try (InputStream stream = ShippedMotions.class.getResourceAsStream(FOLDER + file)) {
            return stream == null ? Optional.empty() : Optional.of(stream.readAllBytes());
        } catch (IOException e) {
            throw new UncheckedIOException("Cannot read the shipped motion file " + file + ".", e);
        }
    }
}
