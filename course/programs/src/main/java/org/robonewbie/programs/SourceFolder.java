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
 * Folder with Java sources: either a Maven project or plain files. The sources are compiled against RoboNewbie and the
 * jars in the subfolder {@code lib}. The compiler does not run their code, and does not read sources outside the
 * folder.
 *
 * @param folder the folder
 * @param deep whether subfolders are included, as in a project
 */
public record SourceFolder(Path folder, boolean deep) {

    /**
     * Returns whether the folder contains sources.
     *
     * @return whether there is anything to compile
     * @throws IOException if it cannot be read
     */
    public boolean hasSources() throws IOException {
        return !sources().isEmpty();
    }

    /**
     * Compiles the sources.
     *
     * @param classes folder for the class files
     * @return the classes with a main method
     * @throws IOException if files cannot be read or written
     * @throws CompilationFailedException if there are errors, which have been printed
     */
    public List<String> compile(Path classes) throws IOException {
        List<Path> sources = sources();
        CompiledClasses made =
                new JavaCompilation("these sources", List.of(), libraries()).compile(files -> files.of(sources));
        made.writeTo(classes);
        return made.programs(classPath(classes));
    }

    /**
     * Returns the class path of the programs.
     *
     * @param classes folder that contains the class files
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
