package org.robonewbie.programs;

import com.sun.source.util.JavacTask;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Function;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.StandardJavaFileManager;
import javax.tools.StandardLocation;

/**
 * Compilation of Java files in memory, against this program and a class path. None of their code is run.
 *
 * @param name name for the files in messages
 * @param sourcePath folders that the compiler searches for further sources
 * @param classPath folders and jars
 */
record JavaCompilation(String name, List<Path> sourcePath, List<Path> classPath) {

    /** File manager of the last compilation, kept for reuse because it has already indexed the jars on the class path. */
    private static final AtomicReference<Optional<StandardJavaFileManager>> KEPT =
            new AtomicReference<>(Optional.empty());

    private static final List<String> OPTIONS =
            List.of("-g", "-XDshould-stop.ifError=FLOW", "-parameters", "-proc:none", "-implicit:class");

    /** Task that uses a compiler. */
    interface Work<T> {
        T of(JavacTask task, CompiledClasses classes) throws IOException;
    }

    /** Creates a compiler for the sources and passes it to {@code work}. */
    <T> T with(CompilerMessages messages, Function<SourceFiles, List<JavaFileObject>> sources, Work<T> work) {
        JavaCompiler compiler = CompilerOfThisJava.get();
        StandardJavaFileManager disk =
                KEPT.getAndSet(Optional.empty()).orElseGet(() -> compiler.getStandardFileManager(null, null, null));
        try {
            disk.setLocationFromPaths(StandardLocation.SOURCE_PATH, sourcePath);
            disk.setLocationFromPaths(
                    StandardLocation.CLASS_PATH,
                    new ClassPath(classPath)
                            .with(ClassPath.ofThisProgram().places())
                            .places());
            SourceFiles files = new SourceFiles(disk);
            CompiledClasses classes = new CompiledClasses(files);
            StringWriter said = new StringWriter();
            JavacTask task = (JavacTask) compiler.getTask(said, classes, messages, OPTIONS, null, sources.apply(files));
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
            KEPT.getAndSet(Optional.of(disk)).ifPresent(JavaCompilation::close);
        }
    }

    private CompilationFailedException overtaxed() {
        return new CompilationFailedException("The compiler cannot read " + name
                + " because an expression or a block is nested too deeply. Split it into several shorter ones.");
    }

    /** Closes a file manager that cannot be kept because a concurrent compilation has already stored another one. */
    private static void close(StandardJavaFileManager other) {
        try {
            other.close();
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
    }

    /**
     * Compiles the files and prints the diagnostics.
     *
     * @throws CompilationFailedException if they have errors
     */
    CompiledClasses compile(Function<SourceFiles, List<JavaFileObject>> sources) {
        CompilerMessages messages = new CompilerMessages();
        Optional<CompiledClasses> classes =
                with(messages, sources, (task, made) -> task.call() ? Optional.of(made) : Optional.empty());
        messages.print(System.err);
        return classes.orElseThrow(() ->
                new CompilationFailedException("The Java file has errors. Fix the first one above and try again."));
    }
}
