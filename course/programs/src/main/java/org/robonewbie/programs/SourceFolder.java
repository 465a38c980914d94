package org.robonewbie.programs;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;
import org.robonewbie.nao.file.SubmittedFolder;

/**
 * A folder with Java sources: a Maven project, or just files. It is compiled with RoboNewbie and the jars in its folder {@code
 * lib}; nothing of it runs for that. The compiler reads the sources of this folder and no others.
 *
 * @param folder the folder
 * @param deep whether folders in it belong to it, as in a project
 */
public record SourceFolder(Path folder, boolean deep) {

    /**
     * Looks whether there is anything to compile.
     *
     * @return whether it has sources
     * @throws IOException if it cannot be read
     */
    public boolean hasSources() throws IOException {
        return !sources().isEmpty();
    }

    /**
     * Compiles the sources.
     *
     * @param classes the folder for the classes
     * @return the classes that have a main method
     * @throws IOException if files cannot be read or written
     * @throws CompilationFailedException if they have mistakes; they have been shown
     */
    public List<String> compile(Path classes) throws IOException {
        List<Path> sources = sources();
        CompiledClasses made =
                new JavaCompilation("these sources", List.of(), libraries()).compile(files -> files.of(sources));
        made.writeTo(classes);
        return made.programs(classPath(classes));
    }

    /**
     * Finds where a program finds its classes and files.
     *
     * @param classes the folder into which they have been compiled
     * @return folders and jars
     * @throws IOException if the folder cannot be read
     */
    public List<Path> classPath(Path classes) throws IOException {
        List<Path> all = new ArrayList<>();
        all.add(classes);
        all.add(folder.resolve("src/main/resources"));
        all.add(root());
        all.addAll(libraries());
        return all.stream().filter(Files::exists).toList();
    }

    private List<Path> sources() throws IOException {
        return new SubmittedFolder(root(), place -> false)
                .files().stream()
                        .filter(file -> file.toString().endsWith(".java"))
                        .filter(file -> deep || folder.equals(file.getParent()))
                        .filter(file -> !Objects.requireNonNull(file.getFileName())
                                .toString()
                                .equals("module-info.java"))
                        .toList();
    }

    private Path root() {
        return !deep
                ? folder
                : Stream.of("src/main/java", "src")
                        .map(folder::resolve)
                        .filter(Files::isDirectory)
                        .findFirst()
                        .orElse(folder);
    }

    private List<Path> libraries() throws IOException {
        List<Path> jars = new ArrayList<>();
        for (Path place : List.of(folder, folder.resolve("lib"))) {
            if (Files.isDirectory(place)) {
                try (Stream<Path> files = Files.list(place)) {
                    files.filter(file -> file.toString().endsWith(".jar"))
                            .sorted()
                            .forEach(jars::add);
                }
            }
        }
        return jars;
    }
}
