package org.robonewbie.app.program;

import com.sun.source.tree.ClassTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.MethodTree;
import com.sun.source.tree.VariableTree;
import com.sun.source.util.JavacTask;
import com.sun.source.util.TreePathScanner;
import com.sun.source.util.Trees;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import javax.lang.model.element.Element;
import javax.lang.model.element.ExecutableElement;
import javax.lang.model.element.TypeElement;
import org.jspecify.annotations.Nullable;

/** Documentation comments of the framework, read from the sources that come along with it. */
final class ApiComments {

    /** Where the build puts them. */
    static final String FOLDER = "/META-INF/sources/";

    /** For each class: comment by member, such as {@code setJointSpeed/2}. */
    private static final Map<String, Map<String, String>> READ = new ConcurrentHashMap<>();

    private ApiComments() {}

    /** Finds the comment of a class or of one of its members; empty if its source is not there. */
    static Optional<String> of(String className, Element element) {
        String outermost = className.replaceFirst("\\$.*", "");
        if (!outermost.startsWith("org.robonewbie.")) {
            return Optional.empty();
        }
        return Optional.ofNullable(
                READ.computeIfAbsent(outermost, ApiComments::read).get(key(element)));
    }

    private static String key(Element element) {
        Element enclosing = element.getEnclosingElement();
        String owner = element instanceof TypeElement || enclosing == null ? "" : enclosing.getSimpleName() + ".";
        String count = element instanceof ExecutableElement method
                ? "/" + method.getParameters().size()
                : "";
        return owner + element.getSimpleName() + count;
    }

    /** The source of a class of the framework; empty if it does not come along. */
    static Optional<String> source(String className) {
        String path = FOLDER + className.replace('.', '/') + ".java";
        try (InputStream stream = ApiComments.class.getResourceAsStream(path)) {
            return stream == null
                    ? Optional.empty()
                    : Optional.of(new String(stream.readAllBytes(), StandardCharsets.UTF_8));
        } catch (IOException unreadable) {
            return Optional.empty();
        }
    }

    private static Map<String, String> read(String className) {
        return source(className)
                .map(text -> JavaSource.of(Path.of(className.replaceAll(".*\\.", "") + ".java"), text)
                        .with(new CompilerMessages(), List.of(), (task, classes) -> comments(task)))
                .orElse(Map.of());
    }

    private static Map<String, String> comments(JavacTask task) throws IOException {
        CompilationUnitTree unit = task.parse().iterator().next();
        Collector collector = new Collector(Trees.instance(task));
        collector.scan(unit, "");
        return collector.comments;
    }

    /** Reads the comments of a class and its members. */
    private static final class Collector extends TreePathScanner<@Nullable Void, String> {

        private final Map<String, String> comments = new HashMap<>();
        private final Trees trees;

        Collector(Trees trees) {
            this.trees = trees;
        }

        @Override
        public @Nullable Void visitClass(ClassTree type, String owner) {
            keep(type.getSimpleName().toString());
            return super.visitClass(type, type.getSimpleName() + ".");
        }

        @Override
        public @Nullable Void visitMethod(MethodTree method, String owner) {
            keep(owner + method.getName() + "/" + method.getParameters().size());
            return null;
        }

        @Override
        public @Nullable Void visitVariable(VariableTree variable, String owner) {
            keep(owner + variable.getName());
            return null;
        }

        private void keep(String key) {
            String comment = trees.getDocComment(getCurrentPath());
            if (comment != null) {
                comments.put(key, comment);
            }
        }
    }
}
