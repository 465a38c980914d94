package org.robonewbie.app.program;

import java.io.File;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;

/**
 * A Java file of the user, compiled in memory together with the other files of its folder that it needs. Nothing is
 * written, so a folder of exercises stays a folder of exercises.
 */
final class JavaSource {

    private static final Pattern PACKAGE = Pattern.compile("^\\s*package\\s+([\\w.]+)\\s*;", Pattern.MULTILINE);

    private final Path file;
    private final String packageName;

    private JavaSource(Path file, String packageName) {
        this.file = file;
        this.packageName = packageName;
    }

    /**
     * Reads which class a file has.
     *
     * @throws CalledWronglyException if it cannot be read
     */
    static JavaSource of(Path file) {
        try {
            Matcher matcher = PACKAGE.matcher(Files.readString(file));
            return new JavaSource(file, matcher.find() ? matcher.group(1) : "");
        } catch (IOException unreadable) {
            throw new CalledWronglyException("The file " + file + " cannot be read (in the folder "
                    + Path.of("").toAbsolutePath() + "). Is its name and folder right?");
        }
    }

    /**
     * Compiles the file.
     *
     * @param classPath the user's folders and jars that it uses
     * @throws CompilationFailedException if it has errors; they have been shown
     */
    AgentProgram compile(List<Path> classPath) {
        return AgentProgram.of(load(classPath).get()).orElseThrow(() -> AgentFinder.withoutMain(simpleName()));
    }

    /**
     * Compiles the file for loading its class repeatedly, each time with static fields of its own.
     *
     * @param classPath the user's folders and jars that it uses
     * @return loads the class of the file
     * @throws CompilationFailedException if it has errors; they have been shown
     */
    Supplier<Class<?>> load(List<Path> classPath) {
        JavaCompiler compiler = Optional.ofNullable(ToolProvider.getSystemJavaCompiler())
                .orElseThrow(() -> new CalledWronglyException(
                        "A Java file can be run by a JDK only, and this Java has no compiler: "
                                + System.getProperty("java.home")));
        try (StandardJavaFileManager disk = compiler.getStandardFileManager(null, null, null);
                CompiledClasses classes = new CompiledClasses(disk)) {
            boolean correct = compiler.getTask(
                            new PrintWriter(System.err, true, Charset.defaultCharset()),
                            classes,
                            null,
                            options(classPath),
                            null,
                            disk.getJavaFileObjects(file))
                    .call();
            if (!correct) {
                throw new CompilationFailedException(
                        "The Java file has mistakes. Correct the line of the first error above and start again.");
            }
            return () -> mainClass(classes.loader(withOwnFolder(classPath)));
        } catch (IOException impossible) {
            throw new UncheckedIOException(impossible);
        }
    }

    private List<String> options(List<Path> classPath) {
        String ownAndRoboNewbie = Stream.concat(
                        classPath.stream().map(Path::toString), Stream.of(System.getProperty("java.class.path")))
                .collect(Collectors.joining(File.pathSeparator));
        return List.of(
                "-g",
                "-parameters",
                "-proc:none",
                "-implicit:class",
                "-sourcepath",
                rootFolder().toString(),
                "-classpath",
                ownAndRoboNewbie);
    }

    private Class<?> mainClass(ClassLoader loader) {
        try {
            return loader.loadClass(packageName.isEmpty() ? simpleName() : packageName + "." + simpleName());
        } catch (ClassNotFoundException none) {
            throw new CalledWronglyException("The file " + file + " has no class " + simpleName()
                    + ". A file and the class in it need the same name.");
        }
    }

    private String simpleName() {
        return file.getFileName().toString().replaceFirst("\\.java$", "");
    }

    private List<Path> withOwnFolder(List<Path> classPath) {
        return Stream.concat(classPath.stream(), Stream.of(rootFolder())).toList();
    }

    /** The folder in which the packages of the file begin. */
    private Path rootFolder() {
        Path folder = Objects.requireNonNull(file.toAbsolutePath().normalize().getParent());
        Path packageFolder = Path.of(packageName.replace('.', '/'));
        if (packageName.isEmpty() || !folder.endsWith(packageFolder)) {
            return folder;
        }
        Path root = folder;
        for (Path ignored : packageFolder) {
            root = Objects.requireNonNull(root.getParent());
        }
        return root;
    }
}
