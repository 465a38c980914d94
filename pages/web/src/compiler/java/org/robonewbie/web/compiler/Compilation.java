package org.robonewbie.web.compiler;

import com.sun.source.tree.CompilationUnitTree;
import com.sun.tools.javac.api.JavacTrees;
import com.sun.tools.javac.main.JavaCompiler;
import com.sun.tools.javac.main.Option;
import com.sun.tools.javac.model.JavacElements;
import com.sun.tools.javac.model.JavacTypes;
import com.sun.tools.javac.tree.JCTree.JCCompilationUnit;
import com.sun.tools.javac.util.Context;
import com.sun.tools.javac.util.Options;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.tools.Diagnostic;
import javax.tools.DiagnosticListener;
import javax.tools.JavaFileManager;
import javax.tools.JavaFileObject;
import org.jspecify.annotations.Nullable;
import org.robonewbie.programs.completion.Completion;
import org.robonewbie.programs.completion.Proposal;
import org.robonewbie.programs.hint.FrameworkNames;
import org.robonewbie.programs.hint.Hints;

/** One run of {@code javac}. */
final class Compilation {

    private static @Nullable Hints hints;

    private final Context context = new Context();
    private final List<Diagnostic<? extends JavaFileObject>> remarks = new ArrayList<>();

    private Compilation(MemoryFiles files) {
        DiagnosticListener<JavaFileObject> listener = remarks::add;
        context.put(DiagnosticListener.class, listener);
        context.put(JavaFileManager.class, files);
        Options options = Options.instance(context);
        options.put(Option.PROC, "none");
        options.put(Option.G, "");
        options.put("should-stop.ifError", "FLOW");
    }

    /**
     * Compiles files.
     *
     * @param files the libraries; receives the class files
     * @param sources the source files
     * @return the diagnostics in javac's order
     */
    static List<Remark> of(MemoryFiles files, List<JavaFileObject> sources) {
        files.forgetMade();
        Compilation compilation = new Compilation(files);
        JavaCompiler compiler = JavaCompiler.instance(compilation.context);
        try {
            compiler.compile(com.sun.tools.javac.util.List.from(sources));
        } catch (Throwable failure) {
            throw new IllegalStateException("The compiler has crashed: " + failure, failure);
        }
        compiler.close();
        Hints known = hints(files);
        return known.withoutFollowUps(compilation.remarks, Compilation::asRemark).stream()
                .map(remark -> new Remark(remark, known.of(asRemark(remark))))
                .toList();
    }

    /**
     * A diagnostic.
     *
     * @param diagnostic javac's diagnostic
     * @param hint advice for beginners; may be empty
     */
    record Remark(Diagnostic<? extends JavaFileObject> diagnostic, String hint) {}

    private static Hints.Remark asRemark(Diagnostic<? extends JavaFileObject> diagnostic) {
        boolean placed =
                diagnostic.getSource() instanceof MemoryFile && diagnostic.getStartPosition() != Diagnostic.NOPOS;
        String place = placed
                ? ((MemoryFile) diagnostic.getSource()).text().substring((int) diagnostic.getStartPosition(), (int)
                        diagnostic.getEndPosition())
                : "";
        return new Hints.Remark(String.valueOf(diagnostic.getCode()), place, diagnostic.getMessage(Locale.ENGLISH));
    }

    /** Returns the hints. The framework's names are read only once, because the library never changes. */
    private static Hints hints(MemoryFiles files) {
        Hints known = hints == null ? new Hints(names(files)) : hints;
        hints = known;
        return known;
    }

    private static FrameworkNames names(MemoryFiles files) {
        Context context = new Compilation(files).context;
        JavaCompiler compiler = JavaCompiler.instance(context);
        compiler.initModules(com.sun.tools.javac.util.List.nil());
        FrameworkNames names = NamesOfTheLibrary.read(JavacElements.instance(context));
        compiler.close();
        return names;
    }

    /**
     * Returns completion proposals.
     *
     * @param files the libraries
     * @param sources the source files, the first one with a placeholder at the cursor
     * @param begun the part of the identifier before the cursor
     * @return the proposals; the documentation field of each contains a tab, the class name, a tab, and the key of its documentation
     */
    static List<Proposal> proposals(MemoryFiles files, List<JavaFileObject> sources, String begun) {
        Context context = new Compilation(files).context;
        Options.instance(context).put(Option.PARAMETERS, "");
        JavaCompiler compiler = JavaCompiler.instance(context);
        compiler.keepComments = true;
        compiler.genEndPos = true;
        com.sun.tools.javac.util.List<JCCompilationUnit> units = compiler.parseFiles(sources);
        CompilationUnitTree asked = units.head;
        compiler.enterTrees(compiler.initModules(units));
        compiler.attribute(compiler.todo);
        Completion.Compiler known = new Completion.Compiler(
                JavacTrees.instance(context), JavacElements.instance(context), JavacTypes.instance(context));
        List<Proposal> proposals = Completion.of(
                known, asked, begun, (className, key) -> "\t" + className + "\t" + key, FrameworkNames.TYPES);
        compiler.close();
        return proposals;
    }
}
