package org.robonewbie.app;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;

/** The files of the whole project, for tests of its rules. */
public final class Project {

    public static final Path ROOT = findRoot();

    private Project() {}

    /** Lists the files with an ending that belong to the sources of any module. */
    public static List<Path> sources(String ending) {
        return files("src", ending);
    }

    /** Lists the folders of all modules: those with a {@code pom.xml}, at the root or in one of its folders. */
    public static List<Path> modules() {
        try (Stream<Path> files = Files.find(ROOT, 3, (file, attributes) -> file.endsWith("pom.xml"))) {
            return files.map(Path::getParent)
                    .filter(module -> !module.equals(ROOT))
                    .sorted()
                    .toList();
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    /** Lists the files with an ending that belong to the product, without those of its tests. */
    public static List<Path> productSources(String ending) {
        return files("src/main", ending);
    }

    private static List<Path> files(String folder, String ending) {
        return modules().stream()
                .map(module -> module.resolve(folder))
                .filter(Files::isDirectory)
                .flatMap(Project::filesBelow)
                .filter(file -> file.toString().endsWith(ending))
                .sorted()
                .toList();
    }

    /** Lists the pages that people read: those at the root and in docs. */
    public static List<Path> pages() {
        try (Stream<Path> atRoot = Files.list(ROOT)) {
            return Stream.concat(atRoot.filter(Files::isRegularFile), filesBelow(ROOT.resolve("docs")))
                    .filter(file -> file.toString().endsWith(".md"))
                    .sorted()
                    .toList();
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    public static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    private static Stream<Path> filesBelow(Path folder) {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.filter(Files::isRegularFile).toList().stream();
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    private static Path findRoot() {
        return Stream.iterate(Path.of("").toAbsolutePath(), Objects::nonNull, Path::getParent)
                .filter(folder -> Files.exists(folder.resolve("mvnw")))
                .findFirst()
                .orElseThrow();
    }
}
