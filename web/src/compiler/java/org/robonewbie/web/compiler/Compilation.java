package org.robonewbie.web.compiler;

import com.sun.tools.javac.main.JavaCompiler;
import com.sun.tools.javac.main.Option;
import com.sun.tools.javac.util.Context;
import com.sun.tools.javac.util.Options;
import java.util.ArrayList;
import java.util.List;
import javax.tools.Diagnostic;
import javax.tools.DiagnosticListener;
import javax.tools.JavaFileManager;
import javax.tools.JavaFileObject;

/** One run of {@code javac}. */
final class Compilation {

    private final List<Diagnostic<? extends JavaFileObject>> remarks = new ArrayList<>();

    private Compilation() {}

    /**
     * Compiles files.
     *
     * @param files the libraries; gets the classes
     * @param sources the files with Java
     * @return what javac has to say, in its order
     */
    static List<Diagnostic<? extends JavaFileObject>> of(MemoryFiles files, List<JavaFileObject> sources) {
        Compilation compilation = new Compilation();
        Context context = new Context();
        DiagnosticListener<JavaFileObject> listener = compilation.remarks::add;
        context.put(DiagnosticListener.class, listener);
        context.put(JavaFileManager.class, files);
        Options options = Options.instance(context);
        options.put(Option.PROC, "none");
        options.put(Option.G, "");
        files.forgetMade();
        JavaCompiler compiler = JavaCompiler.instance(context);
        try {
            compiler.compile(com.sun.tools.javac.util.List.from(sources));
        } catch (Throwable failure) {
            throw new IllegalStateException("The compiler itself has failed: " + failure, failure);
        }
        compiler.close();
        return compilation.remarks;
    }
}
