package org.robonewbie.agent.motion;

import java.io.IOException;
import java.io.InputStream;
import java.net.JarURLConnection;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.URL;
import java.net.URLConnection;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.robonewbie.nao.motion.MotionFile;

/**
 * Finds motions by their names: first {@code motions/NAME.txt} in the working directory, then those that come with the
 * framework. A new motion is a new file; nothing else has to be changed. Own files are read again each time, so an edit shows
 * at the next start of the motion. A motion with {@code left} in its name is also there in its mirror image with {@code right},
 * and the other way round.
 */
public final class MotionLibrary {

    private static final String FOLDER = "motions";
    private static final String ENDING = ".txt";
    private static final Pattern NAME = Pattern.compile("[\\p{Alnum}_-][\\p{Alnum}._ -]*");

    private final Path ownMotions;
    private final Map<String, MotionFile> shippedMotions = new ConcurrentHashMap<>();

    /** Opens the library of this program. */
    public MotionLibrary() {
        this(Path.of(FOLDER));
    }

    /**
     * Opens a library with another folder for the own motions.
     *
     * @param ownMotions a folder, which need not exist
     */
    public MotionLibrary(Path ownMotions) {
        this.ownMotions = ownMotions;
    }

    /**
     * Finds a motion.
     *
     * @param name its name without {@code .txt}
     * @return the file; empty if there is none of this name
     * @throws IOException if the file is there but cannot be read
     */
    public Optional<MotionFile> find(String name) throws IOException {
        if (!NAME.matcher(name).matches()) {
            return Optional.empty();
        }
        Optional<MotionFile> file = findAsItIs(name);
        String other = otherSide(name);
        return file.isPresent() || other.equals(name) ? file : findAsItIs(other).map(found -> mirrored(found, name));
    }

    /** Tells motions that come with the framework from those of the user. */
    boolean isShipped(MotionFile file) {
        return shippedMotions.containsValue(file);
    }

    /**
     * Exchanges left and right.
     *
     * @param file a motion
     * @param name name of the mirror image
     * @return the same motion in the mirror
     */
    static MotionFile mirrored(MotionFile file, String name) {
        MotionFile mirrored = MotionFile.of(file.motion().mirrored().named(name));
        for (String key : List.of("start", "end")) {
            Optional<String> value = file.property(key);
            mirrored = value.isPresent() ? mirrored.withProperty(key, otherSide(value.get())) : mirrored;
        }
        return mirrored;
    }

    private static String otherSide(String text) {
        return text.contains("left") ? text.replace("left", "right") : text.replace("right", "left");
    }

    private Optional<MotionFile> findAsItIs(String name) throws IOException {
        Path own = ownMotions.resolve(name + ENDING);
        return Files.isRegularFile(own) ? Optional.of(MotionFile.load(own)) : findShipped(name);
    }

    /**
     * Lists what there is.
     *
     * @return the names of all motions in alphabetical order
     */
    public SortedSet<String> names() {
        SortedSet<String> names = new TreeSet<>(namesIn(ownMotions));
        URL shipped = MotionLibrary.class.getResource("/" + FOLDER + "/stand" + ENDING);
        if (shipped != null) {
            names.addAll(namesBeside(shipped));
        }
        return Collections.unmodifiableSortedSet(names);
    }

    private Optional<MotionFile> findShipped(String name) throws IOException {
        MotionFile known = shippedMotions.get(name);
        if (known != null) {
            return Optional.of(known);
        }
        try (InputStream stream = MotionLibrary.class.getResourceAsStream("/" + FOLDER + "/" + name + ENDING)) {
            if (stream == null) {
                return Optional.empty();
            }
            MotionFile file = MotionFile.read(name + ENDING, stream);
            shippedMotions.put(name, file);
            return Optional.of(file);
        }
    }

    /** Lists what stands in the same folder or jar as a motion that comes with the framework. */
    private static List<String> namesBeside(URL shipped) {
        try {
            URLConnection connection = shipped.openConnection();
            if (connection instanceof JarURLConnection jar) {
                return namesOf(jar.getJarFile().stream().map(Object::toString).filter(MotionLibrary::isMotionOfJar));
            }
            return namesIn(Path.of(new URI(shipped.toString())).resolveSibling(""));
        } catch (IOException | URISyntaxException unreadable) {
            return List.of();
        }
    }

    private static boolean isMotionOfJar(String entry) {
        return entry.startsWith(FOLDER + "/") && entry.endsWith(ENDING);
    }

    private static List<String> namesIn(Path folder) {
        if (!Files.isDirectory(folder)) {
            return List.of();
        }
        try (Stream<Path> files = Files.list(folder)) {
            return namesOf(files.map(Path::toString).filter(file -> file.endsWith(ENDING)));
        } catch (IOException unreadable) {
            return List.of();
        }
    }

    private static List<String> namesOf(Stream<String> files) {
        return files.map(file -> file.substring(
                        1 + Math.max(file.lastIndexOf('/'), file.lastIndexOf('\\')), file.length() - ENDING.length()))
                .toList();
    }
}
