package org.robonewbie.programs;

import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.util.JavacTask;
import com.sun.source.util.Trees;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.tools.SimpleJavaFileObject;
import org.robonewbie.nao.file.TextFile;
import org.robonewbie.nao.file.UnreadableFileException;
import org.robonewbie.programs.completion.Completion;
import org.robonewbie.programs.completion.PartialWord;
import org.robonewbie.programs.completion.Proposal;
import org.robonewbie.programs.hint.FrameworkNames;

/** A student's Java file. It is compiled in memory, together with the files that it uses from its folder. */
public final class JavaSource {

    private static final Pattern PACKAGE = Pattern.compile("^\\s*package\\s+([\\w.]+)\\s*;", Pattern.MULTILINE);

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
     * @param file the file
     * @return the source
     * @throws CalledWronglyException if it cannot be read
     */
    public static JavaSource of(Path file) {
        try {
            return new JavaSource(file, TextFile.readAndNote(file).content());
        } catch (UnreadableFileException unreadable) {
            throw new CalledWronglyException(String.valueOf(unreadable.getMessage()));
        }
    }

    /**
     * Creates a source from text that may not have been saved yet.
     *
     * @param file the file to which the text belongs
     * @param text the text
     * @return the source
     */
    public static JavaSource of(Path file, String text) {
        return new JavaSource(file, text);
    }

    /** {@return the full name of the class after which the file is named} */
    public String className() {
        return packageName.isEmpty() ? simpleName() : packageName + "." + simpleName();
    }

    private String simpleName() {
        return file.getFileName().toString().replaceFirst("\\.java$", "");
    }

    /**
     * Compiles the file. The returned supplier loads a new copy of the class on each call, with separate static fields.
     *
     * @param classPath the user's folders and jars
     * @return a supplier that loads the class of the file
     * @throws CompilationFailedException if it has errors, which have been printed
     */
    Supplier<Class<?>> load(List<Path> classPath) {
        requireKnownForm();
        CompiledClasses classes = compilation(classPath).compile(files -> List.of(asFile()));
        List<Path> all =
                Stream.concat(classPath.stream(), Stream.of(rootFolder())).toList();
        return () -> mainClass(classes.loader(all));
    }

    private void requireKnownForm() {
        CompactSource.trouble(text, simpleName()).ifPresent(trouble -> {
            throw new CompilationFailedException(trouble);
        });
    }

    /**
     * Compiles the file into a folder.
     *
     * @param classPath the user's folders and jars
     * @param folder folder for the class files
     * @return whether the file has no errors; see {@link #check}
     * @throws IOException if the folder cannot be written
     * @throws CalledWronglyException if the compiler runs out of memory or stack; the message says what to do
     */
    public boolean compile(List<Path> classPath, Path folder) throws IOException {
        CompilerOfThisJava.require();
        Optional<CompiledClasses> classes;
        try {
            classes = compile(classPath, new CompilerMessages());
        } catch (CompilationFailedException overtaxed) {
            throw new CalledWronglyException(String.valueOf(overtaxed.getMessage()));
        }
        if (classes.isPresent()) {
            classes.get().writeTo(folder);
        }
        return classes.isPresent();
    }

    /** Compiles the file. Returns empty if it has errors. */
    Optional<CompiledClasses> compile(List<Path> classPath, CompilerMessages messages) {
        return with(messages, classPath, (task, classes) -> task.call() ? Optional.of(classes) : Optional.empty());
    }

    /**
     * Checks the file without generating code.
     *
     * @param classPath the user's folders and jars
     * @return the diagnostics
     */
    public List<Remark> check(List<Path> classPath) {
        CompilerOfThisJava.require();
        CompilerMessages messages = new CompilerMessages();
        try {
            requireKnownForm();
            return with(messages, classPath, (task, classes) -> {
                task.analyze();
                return messages.remarks();
            });
        } catch (CompilationFailedException refused) {
            return List.of(new Remark(0, 1, 1, true, String.valueOf(refused.getMessage()), ""));
        }
    }

    /**
     * Returns completion proposals.
     *
     * @param classPath the user's folders and jars
     * @param at index of the cursor
     * @return proposals for completing the word before the cursor
     */
    public List<Proposal> complete(List<Path> classPath, int at) {
        CompilerOfThisJava.require();
        PartialWord word = PartialWord.at(text, at);
        try {
            return of(file, word.text())
                    .with(new CompilerMessages(), classPath, (task, classes) -> proposals(task, word.begun()));
        } catch (CompilationFailedException overtaxed) {
            return List.of();
        }
    }

    private static List<Proposal> proposals(JavacTask task, String begun) throws IOException {
        Iterator<? extends CompilationUnitTree> units = task.parse().iterator();
        if (!units.hasNext()) {
            return List.of(); // the compiler has given up
        }
        CompilationUnitTree unit = units.next();
        task.analyze();
        return Completion.of(
                new Completion.Compiler(Trees.instance(task), task.getElements(), task.getTypes()),
                unit,
                begun,
                ApiComments::of,
                FrameworkNames.TYPES);
    }

    /** Creates a compiler for the file and passes it to {@code work}. */
    <T> T with(CompilerMessages messages, List<Path> classPath, JavaCompilation.Work<T> work) {
        return compilation(classPath).with(messages, files -> List.of(asFile()), work);
    }

    private JavaCompilation compilation(List<Path> classPath) {
        return new JavaCompilation(file.toString(), List.of(rootFolder()), classPath);
    }

    private SimpleJavaFileObject asFile() {
        return new SimpleJavaFileObject(file.toUri(), SimpleJavaFileObject.Kind.SOURCE) {
            @Override
            public String getName() {
                return file.toString();
            }

            @Override
            public CharSequence getCharContent(boolean ignoreEncodingErrors) {
                return text;
            }
        };
    }

    private Class<?> mainClass(ClassLoader loader) {
        try {
            return loader.loadClass(className());
        } catch (ClassNotFoundException none) {
            throw new CalledWronglyException("The file " + file + " has no class " + simpleName()
                    + ". A file and its class must have the same name.");
        }
    }

    /** {@return the root folder of the packages} */
    public Path rootFolder() {
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
