package org.robonewbie.programs;

import java.io.IOException;
import java.io.PrintStream;
import java.lang.reflect.Method;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.tools.Diagnostic;
import javax.tools.DiagnosticListener;
import javax.tools.JavaFileObject;
import org.robonewbie.programs.hint.FrameworkNames;
import org.robonewbie.programs.hint.Hints;

/** Collects the diagnostics of a compilation and adds suggestions for missing imports and misspelt names from the framework. */
final class CompilerMessages implements DiagnosticListener<JavaFileObject> {

    private static final Hints HINTS = new Hints(frameworkNames());

    private final List<Diagnostic<? extends JavaFileObject>> all = new ArrayList<>();
    private final Set<String> imports = new TreeSet<>();

    private static FrameworkNames frameworkNames() {
        Map<String, String> types = new TreeMap<>();
        List<String> constants = new ArrayList<>();
        Map<String, SortedSet<String>> methods = new TreeMap<>();
        for (String name : FrameworkNames.TYPES) {
            Class<?> type = type(name);
            types.put(type.getSimpleName(), name);
            if (type.isEnum()) {
                Stream.of(type.getEnumConstants())
                        .map(each -> ((Enum<?>) each).name())
                        .forEach(constants::add);
            }
            methods.put(
                    type.getSimpleName(),
                    Stream.of(type.getMethods())
                            .filter(each -> FrameworkNames.isMeant(
                                    each.getName(), each.getDeclaringClass().getName()))
                            .map(Method::getName)
                            .collect(Collectors.toCollection(TreeSet::new)));
        }
        return new FrameworkNames(types, constants, methods);
    }

    private static Class<?> type(String name) {
        try {
            return Class.forName(name, false, CompilerMessages.class.getClassLoader());
        } catch (ClassNotFoundException impossible) {
            throw new IllegalStateException("There is no class " + name + ".", impossible);
        }
    }

    @Override
    public void report(Diagnostic<? extends JavaFileObject> diagnostic) {
        all.add(diagnostic);
    }

    /** Returns all errors and warnings with advice. */
    List<Remark> remarks() {
        return mistakes().stream()
                .map(mistake -> new Remark(
                        (int) mistake.getStartPosition(),
                        (int) mistake.getEndPosition(),
                        (int) Math.max(0, mistake.getLineNumber()),
                        mistake.getKind() == Diagnostic.Kind.ERROR,
                        mistake.getMessage(null),
                        hint(mistake)))
                .toList();
    }

    private List<Diagnostic<? extends JavaFileObject>> mistakes() {
        List<Diagnostic<? extends JavaFileObject>> mistakes = all.stream()
                .filter(each -> each.getKind() == Diagnostic.Kind.ERROR || each.getKind() == Diagnostic.Kind.WARNING)
                .toList();
        return HINTS.withoutFollowUps(mistakes, CompilerMessages::asRemark);
    }

    /** Prints the diagnostics in the compiler's format, each followed by advice. */
    void print(PrintStream out) {
        List<Diagnostic<? extends JavaFileObject>> mistakes = mistakes();
        for (Diagnostic<? extends JavaFileObject> each : mistakes) {
            out.println(each);
            String hint = hint(each);
            if (!hint.isEmpty()) {
                out.println("  " + hint);
            }
        }
        long errors = mistakes.stream()
                .filter(each -> each.getKind() == Diagnostic.Kind.ERROR)
                .count();
        if (errors > 0) {
            out.println(errors == 1 ? "1 error" : errors + " errors");
        }
        if (!imports.isEmpty()) {
            out.println("Add at the top of the file:");
            imports.forEach(line -> out.println("  " + line));
        }
    }

    private String hint(Diagnostic<? extends JavaFileObject> mistake) {
        Hints.Remark remark = asRemark(mistake);
        HINTS.missingImport(remark).ifPresent(imports::add);
        return HINTS.of(remark);
    }

    private static Hints.Remark asRemark(Diagnostic<? extends JavaFileObject> mistake) {
        return new Hints.Remark(String.valueOf(mistake.getCode()), text(mistake), mistake.getMessage(Locale.ROOT));
    }

    /** Returns the source text underlined by a diagnostic. */
    private static String text(Diagnostic<? extends JavaFileObject> mistake) {
        JavaFileObject source = mistake.getSource();
        if (source == null || mistake.getStartPosition() == Diagnostic.NOPOS) {
            return "";
        }
        try {
            CharSequence program = source.getCharContent(true);
            return program.subSequence((int) mistake.getStartPosition(), (int) mistake.getEndPosition())
                    .toString();
        } catch (IOException unreadable) {
            return "";
        }
    }
}
