package org.robonewbie.competition.team;

import java.io.IOException;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.StandardLocation;
import javax.tools.ToolProvider;

/**
 * A folder with Java sources: a Maven project, or just files. It is compiled with RoboNewbie and the jars in its folder {@code
 * lib}; nothing of the team runs for that. The compiler reads the sources of this folder and no others.
 *
 * @param folder the folder
 * @param deep whether folders in it belong to it, as in a project
 */
record SourceFolder(Path folder, boolean deep) {

    boolean hasSources() throws IOException {
        return !sources().isEmpty();
    }

    /** Compiles the sources into another folder, and returns what the compiler says if it cannot. */
    Optional<String> compile(Path classes) throws IOException {
        JavaCompiler compiler = compiler();
        StringWriter messages = new StringWriter();
        try (StandardJavaFileManager disk = compiler.getStandardFileManager(null, null, null)) {
            disk.setLocationFromPaths(
                    StandardLocation.CLASS_PATH,
                    ClassPath.ofThisProgram().with(libraries()).places());
            SourceFiles files = new SourceFiles(disk);
            boolean correct = compiler.getTask(messages, files, null, options(classes), null, files.of(sources()))
                    .call();
            return correct ? Optional.empty() : Optional.of(messages.toString());
        }
    }

    /**
     * Finds the compiler.
     *
     * @throws WrongEntryException if this Java has none
     */
    static JavaCompiler compiler() {
        return Optional.ofNullable(ToolProvider.getSystemJavaCompiler())
                .orElseThrow(() ->
                        new WrongEntryException("Teams with Java files need a JDK, and this Java has no compiler: "
                                + System.getProperty("java.home")));
    }

    private static List<String> options(Path classes) {
        return List.of(
                "-g",
                "-parameters",
                "-proc:none",
                "-d",
                classes.toString(),
                "-sourcepath",
                classes.toString()); // else sources on the class path would be compiled, too
    }

    /** Where the program finds its classes and files when they have been compiled into a folder. */
    List<Path> classPath(Path classes) throws IOException {
        List<Path> all = new ArrayList<>();
        all.add(classes);
        all.add(folder.resolve("src/main/resources"));
        all.add(root());
        all.addAll(libraries());
        return all.stream().filter(Files::exists).toList();
    }

    private List<Path> sources() throws IOException {
        return TeamFolder.filesOf(root()).stream()
                .filter(file -> file.toString().endsWith(".java"))
                .filter(file -> deep || folder.equals(file.getParent()))
                .filter(file ->
                        !Objects.requireNonNull(file.getFileName()).toString().equals("module-info.java"))
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
