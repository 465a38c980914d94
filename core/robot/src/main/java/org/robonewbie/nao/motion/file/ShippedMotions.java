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
 * The motions shipped with the framework, stored as class path resources {@code /motions/NAME.txt}. The resource {@code
 * /motions/index} lists their names, one per line, because not every class path can list its resources.
 */
public final class ShippedMotions implements MotionSource {

    private static final String FOLDER = "/motions/";

    /** Creates a source of the shipped motions. */
    public ShippedMotions() {}

    /**
     * Loads a motion.
     *
     * @param name the motion's name, such as {@code walk-forward}
     * @return the motion
     * @throws IllegalArgumentException if there is no shipped motion with this name
     */
    public static Motion motion(String name) {
        return file(name).motion();
    }

    /**
     * Loads the file of a motion.
     *
     * @param name the motion's name, such as {@code walk-forward}
     * @return the file
     * @throws IllegalArgumentException if there is no shipped motion with this name
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
