package org.robonewbie.app.program;

import com.sun.source.util.JavacTask;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.SimpleJavaFileObject;
import javax.tools.StandardJavaFileManager;
import javax.tools.StandardLocation;
import org.robonewbie.competition.team.ClassPath;
import org.robonewbie.competition.team.SourceFiles;
import org.robonewbie.nao.file.TextFile;
import org.robonewbie.nao.file.UnreadableFileException;

/**
 * A Java file of the user, compiled in memory together with the other files of its folder that it needs. Nothing is
 * written, so a folder of exercises stays a folder of exercises.
 */
final class JavaSource {

    /** The files that the compiler has used last: whoever compiles next need not read all archives of the class path again. */
    private static final AtomicReference<Optional<StandardJavaFileManager>> KEPT =
            new AtomicReference<>(Optional.empty());

    private static final Pattern PACKAGE = Pattern.compile("^\\s*package\\s+([\\w.]+)\\s*;", Pattern.MULTILINE);

    private static final List<String> OPTIONS =
            List.of("-g", "-XDshould-stop.ifError=FLOW", "-parameters", "-proc:none", "-implicit:class");

    private final Path file;
    private final String text;
    private final String packageName;

    private JavaSource(Path file, String text) {
        Matcher matcher = PACKAGE.matcher(text);
        this.file = file;
        this.text = text;
        this.packageName = matcher.find() ? matcher.group(1) : "";
    }

    /**
     * Reads a file.
     *
     * @throws CalledWronglyException if it cannot be read
     */
    static JavaSource of(Path file) {
        try {
            return new JavaSource(file, TextFile.readAndNote(file).content());
        } catch (UnreadableFileException unreadable) {
            throw new CalledWronglyException(String.valueOf(unreadable.getMessage()));
        }
    }

    /** Takes a text that need not be saved yet as that of a file. */
    static JavaSource of(Path file, String text) {
        return new JavaSource(file, text);
    }

    /** The full name of the class that the file is named after. */
    String className() {
        return packageName.isEmpty() ? simpleName() : packageName + "." + simpleName();
    }

    /**
     * Compiles the file.
     *
     * @param classPath the user's folders and jars that it uses
     * @throws CompilationFailedException if it has errors; they have been shown
     */
    AgentProgram compile(List<Path> classPath) {
        Class<?> type = load(classPath).get();
        return AgentProgram.of(type).orElseThrow(() -> AgentFinder.withoutMain(type));
    }

    /**
     * Compiles the file for loading its class repeatedly, each time with static fields of its own.
     *
     * @param classPath the user's folders and jars that it uses
     * @return loads the class of the file
     * @throws CompilationFailedException if it has errors; they have been shown
     */
    Supplier<Class<?>> load(List<Path> classPath) {
        Optional<String> tooNew = CompactSource.trouble(text, simpleName());
        if (tooNew.isPresent()) {
            throw new CompilationFailedException(tooNew.get());
        }
        CompilerMessages messages = new CompilerMessages();
        Optional<CompiledClasses> classes = compile(classPath, messages);
        messages.print(System.err);
        return classes.map(made -> (Supplier<Class<?>>) () -> mainClass(made.loader(withOwnFolder(classPath))))
                .orElseThrow(() -> new CompilationFailedException(
                        "The Java file has mistakes. Correct the line of the first error above and start again."));
    }

    /**
     * Compiles the file.
     *
     * @param classPath the user's folders and jars that it uses
     * @param messages hears what the compiler says
     * @return its classes; empty if it has mistakes
     */
    Optional<CompiledClasses> compile(List<Path> classPath, CompilerMessages messages) {
        return with(messages, classPath, (task, classes) -> task.call() ? Optional.of(classes) : Optional.empty());
    }

    /** Lets the compiler read the file without making anything of it. */
    void check(List<Path> classPath, CompilerMessages messages) {
        with(messages, classPath, (task, classes) -> {
            task.analyze();
            return classes;
        });
    }

    /** What the compiler is to do with the file. */
    interface Work<T> {
        T of(JavacTask task, CompiledClasses classes) throws IOException;
    }

    /** Does something with the compiler. */
    <T> T with(CompilerMessages messages, List<Path> classPath, Work<T> work) {
        JavaCompiler compiler = CompilerOfThisJava.get();
        StandardJavaFileManager disk =
                KEPT.getAndSet(Optional.empty()).orElseGet(() -> compiler.getStandardFileManager(null, null, null));
        try {
            disk.setLocationFromPaths(StandardLocation.SOURCE_PATH, List.of(rootFolder()));
            disk.setLocationFromPaths(
                    StandardLocation.CLASS_PATH,
                    new ClassPath(classPath)
                            .with(ClassPath.ofThisProgram().places())
                            .places());
            CompiledClasses classes = new CompiledClasses(new SourceFiles(disk));
            StringWriter said = new StringWriter();
            JavacTask task =
                    (JavacTask) compiler.getTask(said, classes, messages, OPTIONS, null, List.of(new Text(file, text)));
            T done = work.of(task, classes);
            if (said.toString().contains(StackOverflowError.class.getName())) {
                throw overtaxed();
            }
            System.err.print(said);
            return done;
        } catch (StackOverflowError tooDeep) {
            throw overtaxed();
        } catch (IllegalStateException failed) {
            throw failed.getCause() instanceof StackOverflowError ? overtaxed() : failed;
        } catch (IOException impossible) {
            throw new UncheckedIOException(impossible);
        } finally {
            KEPT.getAndSet(Optional.of(disk)).ifPresent(JavaSource::close);
        }
    }

    private CompilationFailedException overtaxed() {
        return new CompilationFailedException("The compiler cannot read " + file
                + ", since an expression or a block in it is nested too deeply. Split it into several shorter ones.");
    }

    /** Two have compiled at the same time, and one of them has kept its files already. */
    private static void close(StandardJavaFileManager other) {
        try {
            other.close();
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
    }

    /** The text as the compiler reads it. */
    private static final class Text extends SimpleJavaFileObject {

        private final Path file;
        private final String content;

        Text(Path file, String content) {
            super(file.toUri(), Kind.SOURCE);
            this.file = file;
            this.content = content;
        }

        @Override
        public String getName() {
            return file.toString();
        }

        @Override
        public CharSequence getCharContent(boolean ignoreEncodingErrors) {
            return content;
        }
    }

    private Class<?> mainClass(ClassLoader loader) {
        try {
            return loader.loadClass(className());
        } catch (ClassNotFoundException none) {
            throw new CalledWronglyException("The file " + file + " has no class " + simpleName()
                    + ". A file and the class in it need the same name.");
        }
    }

    /** The name of the file without its ending. */
    String simpleName() {
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
