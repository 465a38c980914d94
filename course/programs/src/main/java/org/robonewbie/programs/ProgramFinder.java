package org.robonewbie.programs;

import java.io.UncheckedIOException;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.robonewbie.agent.Agent;
import org.robonewbie.nao.text.Spelling;

/** Finds a program, given the name of an example, a class or a Java file. */
public final class ProgramFinder {

    private final SortedMap<String, String> examples = ExampleCatalogue.classNames();
    private final List<Path> classPath;

    /**
     * Creates a finder. Examples take precedence over the user's classes with the same name.
     *
     * @param classPath folders and jars with the user's own classes
     */
    public ProgramFinder(List<Path> classPath) {
        this.classPath = classPath;
    }

    /**
     * Finds a program.
     *
     * @param name simple name of an example, a class or a Java file
     * @return the program
     * @throws CalledWronglyException if there is no such program; the message lists the examples
     */
    public Program find(String name) {
        return programOf(findClass(name).get());
    }

    /**
     * Finds a class and returns a supplier that loads a new copy of it on each call, with separate static fields.
     * Classes of RoboNewbie are not reloaded.
     *
     * @param name simple name of an example, a class or a Java file
     * @return a supplier of the class
     * @throws CalledWronglyException if there is no such program; the message lists the examples
     */
    public Supplier<Class<?>> findClass(String name) {
        if (name.endsWith(".java")) {
            return source(name).load(classPath);
        }
        String className = examples.getOrDefault(name, name);
        if (ownClass(className).isEmpty()) {
            throw unknown(name);
        }
        return () -> ownClass(className).orElseThrow();
    }

    /**
     * Finds a program and returns a supplier that loads a new copy of it on each call, with separate static fields.
     * Classes of RoboNewbie are not reloaded.
     *
     * @param name simple name of an example, a class or a Java file
     * @return a supplier of the program
     * @throws CalledWronglyException if there is no such program; the message lists the examples
     */
    public Supplier<Program> findRepeatedly(String name) {
        Supplier<Class<?>> types = findClass(name);
        programOf(types.get());
        return () -> programOf(types.get());
    }

    private static Program programOf(Class<?> type) {
        return Program.of(type).orElseThrow(() -> withoutMain(type));
    }

    private static JavaSource source(String name) {
        CompilerOfThisJava.require();
        return JavaSource.of(Path.of(name));
    }

    /**
     * Finds a program by the full name of its class.
     *
     * @param className full name of the class
     * @return the program
     * @throws CalledWronglyException if the class does not exist or has no {@code main}
     */
    public Program ofClass(String className) {
        return programOf(ownClass(className).orElseThrow(() -> unknown(className)));
    }

    /** {@return the examples, one per line, each with its summary} */
    public String listOfExamples() {
        return examples.entrySet().stream()
                .map(example -> String.format("  %-28s %s", example.getKey(), ApiComments.summary(example.getValue()))
                        .stripTrailing())
                .collect(Collectors.joining(System.lineSeparator(), "The examples are:" + System.lineSeparator(), ""));
    }

    private Optional<Class<?>> ownClass(String name) {
        return load(name, loaderOf(classPath));
    }

    static Optional<Class<?>> load(String className, ClassLoader loader) {
        try {
            return Optional.of(Class.forName(className, false, loader));
        } catch (ClassNotFoundException | LinkageError none) {
            return Optional.empty();
        }
    }

    /**
     * Creates a class loader for the user's own classes and those of RoboNewbie.
     *
     * @param classPath folders and jars
     * @return the class loader
     */
    public static URLClassLoader loaderOf(List<Path> classPath) {
        return new URLClassLoader(
                classPath.stream().map(ProgramFinder::urlOf).toArray(URL[]::new), ProgramFinder.class.getClassLoader());
    }

    private static URL urlOf(Path folderOrJar) {
        try {
            return folderOrJar.toUri().toURL();
        } catch (MalformedURLException impossible) {
            throw new UncheckedIOException(impossible);
        }
    }

    static CalledWronglyException withoutMain(Class<?> type) {
        if (Program.isShort(type)) {
            return new CalledWronglyException(CompactSource.needsNewerJava(
                            "The main method of " + type.getSimpleName(),
                            Runtime.version().feature())
                    + ", or write: public static void main(String[] args)");
        }
        String robot = Agent.class.isAssignableFrom(type) ? "" : """
                 It is not a robot either: write "public class %s extends Agent", with "import org.robonewbie.agent.Agent;" at the top, and
                put the behaviour of the robot into "protected void think()".""".formatted(type.getSimpleName());
        return new CalledWronglyException("""
                %1$s cannot be run, since it has no main method.%2$s Add this method:
                  public static void main(String[] args) {
                    new %1$s().run(args);
                  }""".formatted(type.getSimpleName(), robot));
    }

    private CalledWronglyException unknown(String name) {
        Path file = Path.of(name + ".java");
        String question =
                Files.isRegularFile(file) ? " Did you mean " + file + "?" : Spelling.question(name, examples.keySet());
        return new CalledWronglyException("""
                There is no agent "%s".%s
                %s
                To run your own agent, name its file, for example: robonewbie run MyAgent.java""".formatted(name, question, listOfExamples()));
    }
}
