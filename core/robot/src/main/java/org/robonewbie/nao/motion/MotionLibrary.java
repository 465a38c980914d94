package org.robonewbie.nao.motion;

import java.io.IOException;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import org.robonewbie.nao.text.FileName;

/**
 * Finds motions by name, first among the user's motions and then among those shipped with the framework. A new file is
 * a new motion; nothing has to be registered. The user's files are read again on each call, so an edit takes effect the
 * next time the motion starts. A motion with {@code left} in its name is also available mirrored with {@code right},
 * and vice versa.
 *
 * <pre>{@code
 * MotionLibrary library = MotionFiles.library();
 * Motion wave = library.find("wave").orElseThrow().motion();
 * }</pre>
 */
public final class MotionLibrary {

    private final MotionSource own;
    private final MotionSource shipped;
    private final Map<String, MotionFile> shippedFiles = new HashMap<>();

    /**
     * Creates a library.
     *
     * @param own the user's motions
     * @param shipped the motions shipped with the framework, which never change
     */
    public MotionLibrary(MotionSource own, MotionSource shipped) {
        this.own = own;
        this.shipped = shipped;
    }

    /**
     * Finds a motion.
     *
     * @param name the motion's name without {@code .txt}, in any script
     * @return the file; empty if no motion has this name
     * @throws IOException if the file exists but cannot be read
     */
    public Optional<MotionFile> find(String name) throws IOException {
        if (FileName.problem(name).isPresent()) {
            return Optional.empty();
        }
        Optional<MotionFile> file = findUnmirrored(name);
        String other = MotionFile.otherSide(name);
        return file.isPresent() || other.equals(name)
                ? file
                : findUnmirrored(other).map(found -> found.mirrored(name));
    }

    /**
     * {@return whether a file is shipped with the framework}
     *
     * @param file a result of {@link #find}
     */
    public boolean isShipped(MotionFile file) {
        return shippedFiles.containsValue(file);
    }

    /** {@return a new set with the names of all motions that {@link #find} finds without mirroring, in alphabetical order} */
    public SortedSet<String> names() {
        SortedSet<String> names = new TreeSet<>(own.names());
        names.removeIf(name -> FileName.problem(name).isPresent());
        names.addAll(shipped.names());
        return names;
    }

    private Optional<MotionFile> findUnmirrored(String name) throws IOException {
        Optional<byte[]> bytes = own.read(name);
        return bytes.isPresent() ? bytes.map(content -> parse(name, content)) : findShipped(name);
    }

    private Optional<MotionFile> findShipped(String name) throws IOException {
        if (!shippedFiles.containsKey(name)) {
            shipped.read(name).ifPresent(content -> shippedFiles.put(name, parse(name, content)));
        }
        return Optional.ofNullable(shippedFiles.get(name));
    }

    private static MotionFile parse(String name, byte[] content) {
        return MotionFile.parse(name + ".txt", content);
    }
}
