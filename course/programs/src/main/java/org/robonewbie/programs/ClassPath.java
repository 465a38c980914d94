package org.robonewbie.programs;

import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.URI;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.jar.Attributes;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robonewbie.nao.file.TemporaryFiles;

/**
 * Class path of a Java process. The option {@code -cp} cannot express a path that contains the path separator or a
 * character that needs more than 16 bits, such as an emoji. If there is such a path, the option refers to an empty
 * temporary jar instead, whose manifest lists all entries as URLs.
 *
 * @param places absolute paths of folders and jars
 */
public record ClassPath(List<Path> places) {

    /** The temporary jars, which are kept until this process ends, because child processes read them. */
    private static final Map<ClassPath, Path> JARS = new ConcurrentHashMap<>();

    /** Makes all paths absolute. */
    public ClassPath {
        places =
                places.stream().map(place -> place.toAbsolutePath().normalize()).toList();
    }

    /** {@return this program's class path, or only its own jar if it was started through a temporary jar} */
    public static ClassPath ofThisProgram() {
        Path own = ownPlace();
        return new ClassPath(
                canBeOption(own)
                        ? Stream.of(System.getProperty("java.class.path").split(File.pathSeparator, -1))
                                .map(Path::of)
                                .toList()
                        : List.of(own));
    }

    /** {@return this program's jar; empty if its classes are in folders, as in an IDE} */
    public static Optional<Path> ownJar() {
        return Optional.of(ownPlace()).filter(Files::isRegularFile);
    }

    private static Path ownPlace() {
        try {
            return Path.of(ClassPath.class
                    .getProtectionDomain()
                    .getCodeSource()
                    .getLocation()
                    .toURI());
        } catch (URISyntaxException impossible) {
            throw new IllegalStateException(impossible);
        }
    }

    /**
     * Appends entries.
     *
     * @param more folders and jars to append
     * @return the extended class path
     */
    public ClassPath with(List<Path> more) {
        return new ClassPath(Stream.concat(places.stream(), more.stream()).toList());
    }

    /** {@return the entries as URLs in one string, which {@link #read} parses} */
    public String text() {
        return places.stream().map(place -> place.toUri().toASCIIString()).collect(Collectors.joining(" "));
    }

    /**
     * Parses the result of {@link #text}.
     *
     * @param text the URLs
     * @return the paths
     */
    public static List<Path> read(String text) {
        return Stream.of(text.split(" ", -1))
                .filter(address -> !address.isEmpty())
                .map(URI::create)
                .map(Path::of)
                .toList();
    }

    /**
     * Returns the argument for the option {@code -cp}.
     *
     * @return the argument
     * @throws CalledWronglyException if the option cannot express the path of the temporary folder either
     */
    public String option() {
        return files().stream().map(Path::toString).collect(Collectors.joining(File.pathSeparator));
    }

    /** {@return the files that a process with this class path reads, including its JVM} */
    public List<Path> readable() {
        return Stream.of(places.stream(), files().stream(), Stream.of(Path.of(System.getProperty("java.home"))))
                .flatMap(each -> each)
                .distinct()
                .map(place -> place.toAbsolutePath().normalize())
                .toList();
    }

    /** {@return the files and folders in the argument of {@code -cp}} */
    List<Path> files() {
        return places.stream().allMatch(ClassPath::canBeOption)
                ? places
                : List.of(JARS.computeIfAbsent(this, ClassPath::jar));
    }

    private static boolean canBeOption(Path place) {
        return obstacle(place).isEmpty();
    }

    /**
     * Finds a character that the option {@code -cp} cannot express.
     *
     * @param place a folder or jar
     * @return the first such character in the absolute path; empty if there is none
     */
    public static Optional<String> obstacle(Path place) {
        return place.toAbsolutePath()
                .toString()
                .codePoints()
                .filter(letter -> Character.isSupplementaryCodePoint(letter) || letter == File.pathSeparatorChar)
                .mapToObj(Character::toString)
                .findFirst();
    }

    private Path jar() {
        Manifest manifest = new Manifest();
        manifest.getMainAttributes().put(Attributes.Name.MANIFEST_VERSION, "1.0");
        manifest.getMainAttributes().put(Attributes.Name.CLASS_PATH, text());
        try {
            Path jar = TemporaryFiles.file("robonewbie-classes", ".jar");
            jar.toFile().deleteOnExit();
            Optional<String> obstacle = obstacle(jar);
            if (obstacle.isPresent()) {
                throw new CalledWronglyException("Java does not support the character \"" + obstacle.get()
                        + "\" in the path of " + jar.getParent() + ". " + TemporaryFiles.howToChoose());
            }
            try (OutputStream file = Files.newOutputStream(jar);
                    JarOutputStream out = new JarOutputStream(file, manifest)) {
                out.finish();
            }
            return jar;
        } catch (IOException unwritable) {
            throw new UncheckedIOException(unwritable.getMessage(), unwritable);
        }
    }
}
