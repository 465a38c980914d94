package org.robonewbie.app.program;

import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.util.JavacTask;
import com.sun.source.util.Trees;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import javax.tools.Diagnostic;
import org.robonewbie.app.hint.FrameworkNames;
import org.robonewbie.nao.file.TemporaryFiles;
import org.robonewbie.studio.completion.BegunWord;
import org.robonewbie.studio.completion.Completion;
import org.robonewbie.studio.completion.Proposal;

/** A Java file that somebody is working on: what the compiler says about it, and how it starts. */
public final class StudentsProgram {

    private final Path file;
    private final String text;
    private final JavaSource source;
    private final List<Path> classPath;

    private StudentsProgram(Path file, String text, List<Path> classPath) {
        this.file = file;
        this.text = text;
        CompilerOfThisJava.require();
        this.source = JavaSource.of(file, text);
        this.classPath = classPath;
    }

    /**
     * What the compiler says about a place in the file.
     *
     * @param from index of the first character that is meant, -1 if none is
     * @param to index after the last one
     * @param line number of its line, from 1; 0 if none is meant
     * @param serious whether it is a mistake and no mere warning
     * @param text the compiler's own words
     * @param hint what to do; empty if nothing is to be added
     */
    public record Remark(long from, long to, long line, boolean serious, String text, String hint) {}

    /**
     * Takes a text as that of a file, whether it is saved or not.
     *
     * @param file where it is or will be
     * @param text the text
     * @param classPath folders and jars that it uses
     * @return the program
     */
    public static StudentsProgram of(Path file, String text, List<Path> classPath) {
        return new StudentsProgram(file, text, classPath);
    }

    /** {@return what the compiler says about it} */
    public List<Remark> check() {
        Optional<String> tooNew = CompactSource.trouble(text, source.simpleName());
        if (tooNew.isPresent()) {
            return refused(tooNew.get());
        }
        CompilerMessages messages = new CompilerMessages();
        try {
            source.check(classPath, messages);
        } catch (CompilationFailedException overtaxed) {
            return refused(String.valueOf(overtaxed.getMessage()));
        }
        return messages.remarks().stream().map(StudentsProgram::remark).toList();
    }

    private static List<Remark> refused(String why) {
        return List.of(new Remark(0, 1, 1, true, why, ""));
    }

    /**
     * Proposes what could be written.
     *
     * @param at index of the place
     * @return proposals that go on with the word before the place
     */
    public List<Proposal> complete(int at) {
        BegunWord word = BegunWord.at(text, at);
        try {
            return JavaSource.of(file, word.text())
                    .with(new CompilerMessages(), classPath, (task, classes) -> proposals(task, word.begun()));
        } catch (CompilationFailedException overtaxed) {
            return List.of();
        }
    }

    private static List<Proposal> proposals(JavacTask task, String begun) throws IOException {
        Iterator<? extends CompilationUnitTree> units = task.parse().iterator();
        if (!units.hasNext()) {
            return List.of(); // the compiler has broken off
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

    private static Remark remark(CompilerMessages.Remark said) {
        Diagnostic<?> mistake = said.mistake();
        return new Remark(
                mistake.getStartPosition(),
                mistake.getEndPosition(),
                Math.max(0, mistake.getLineNumber()),
                mistake.getKind() == Diagnostic.Kind.ERROR,
                mistake.getMessage(null),
                said.hint());
    }

    /**
     * Compiles the program into a folder of its own.
     *
     * @return what a {@link WaitingProcess} needs to start it; empty if it has mistakes
     * @throws IOException if the folder cannot be written
     * @throws CalledWronglyException if the program cannot be run; the message says what to do
     */
    public Optional<Compiled> compile() throws IOException {
        Optional<CompiledClasses> classes;
        try {
            classes = source.compile(classPath, new CompilerMessages());
        } catch (CompilationFailedException overtaxed) {
            throw new CalledWronglyException(String.valueOf(overtaxed.getMessage()));
        }
        if (classes.isEmpty()) {
            return Optional.empty();
        }
        Path folder = TemporaryFiles.folder("robonewbie-program");
        classes.get().writeTo(folder);
        return Optional.of(new Compiled(source.className(), folder));
    }

    /**
     * A program that can be started.
     *
     * @param className its class
     * @param folder its compiled classes
     */
    public record Compiled(String className, Path folder) {}
}
