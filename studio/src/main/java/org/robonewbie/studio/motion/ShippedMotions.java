package org.robonewbie.studio.motion;

import java.io.IOException;
import java.io.InputStream;
import java.net.JarURLConnection;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.URL;
import java.net.URLConnection;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.MotionFile;

/** The motions that come with the framework, to be read only. */
final class ShippedMotions {

    private static final String FOLDER = "/motions";
    private static final String ENDING = ".txt";

    private ShippedMotions() {}

    /** Lists their names in alphabetical order. */
    static List<String> names() {
        URL folder = MotionFile.class.getResource(FOLDER);
        if (folder == null) {
            return List.of();
        }
        try {
            URLConnection connection = folder.openConnection();
            if (connection instanceof JarURLConnection jar) {
                return names(jar.getJarFile().stream()
                        .map(entry -> "/" + entry.getName())
                        .filter(name -> name.startsWith(FOLDER + "/")));
            }
            try (Stream<Path> files = Files.list(Path.of(new URI(folder.toString())))) {
                return names(files.map(file -> "/" + file.getFileName()));
            }
        } catch (IOException | URISyntaxException unreadable) {
            return List.of();
        }
    }

    private static List<String> names(Stream<String> files) {
        return files.filter(file -> file.endsWith(ENDING))
                .map(file -> file.substring(file.lastIndexOf('/') + 1, file.length() - ENDING.length()))
                .sorted()
                .toList();
    }

    /** Reads one of them; empty if there is none of this name. */
    static Optional<byte[]> read(String name) throws IOException {
        if (!names().contains(name)) {
            return Optional.empty();
        }
        try (InputStream stream = MotionFile.class.getResourceAsStream(FOLDER + "/" + name + ENDING)) {
            return stream == null ? Optional.empty() : Optional.of(stream.readAllBytes());
        }
    }

    /** Gives a motion that is known to exist. */
    static Motion motion(String name) {
        try (InputStream stream = MotionFile.class.getResourceAsStream(FOLDER + "/" + name + ENDING)) {
            if (stream == null) {
                throw new IllegalStateException("The framework comes without its motion \"" + name + "\".");
            }
            return MotionFile.read(name + ENDING, stream).motion();
        } catch (IOException e) {
            throw new IllegalStateException("The motion \"" + name + "\" cannot be read.", e);
        }
    }
}
