package org.robonewbie.programs;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Stream;

/**
 * Catalogue of the examples: the classes with a {@code main} method in {@code org.robonewbie.examples} and {@code
 * org.robonewbie.team}.
 */
public final class ExampleCatalogue {

    /** Name of the first example of the tutorial. */
    public static final String FIRST_EXAMPLE = "Agent_BasicStructure";

    private static final List<String> PACKAGES = List.of("org.robonewbie.examples", "org.robonewbie.team");

    private ExampleCatalogue() {}

    /** {@return the full class names of the examples on the class path, by simple name} */
    public static SortedMap<String, String> classNames() {
        SortedMap<String, String> classNames = new TreeMap<>(String.CASE_INSENSITIVE_ORDER);
        try {
            for (String each : PACKAGES) {
                for (var places = loader().getResources(folder(each)); places.hasMoreElements(); ) {
                    ResourceFolder.read(places.nextElement(), folder(each), path -> addAll(each, path, classNames));
                }
            }
        } catch (IOException unreadable) {
            throw new UncheckedIOException("The examples cannot be read", unreadable);
        }
        return classNames;
    }

    private static String folder(String packageName) {
        return packageName.replace('.', '/');
    }

    private static void addAll(String packageName, Path folder, SortedMap<String, String> classNames)
            throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            files.filter(file -> file.toString().endsWith(".class"))
                    .map(file -> packageName + "." + classNameOf(folder.relativize(file)))
                    .filter(name -> ProgramFinder.load(name, loader())
                            .flatMap(Program::of)
                            .isPresent())
                    .forEach(name -> classNames.put(name.substring(name.lastIndexOf('.') + 1), name));
        }
    }

    private static String classNameOf(Path file) {
        String separator = file.getFileSystem().getSeparator();
        String name = file.toString().replace(separator, ".");
        return name.substring(0, name.length() - ".class".length());
    }

    private static ClassLoader loader() {
        return ExampleCatalogue.class.getClassLoader();
    }
}
