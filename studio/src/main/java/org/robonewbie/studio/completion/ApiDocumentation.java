package org.robonewbie.studio.completion;

import com.sun.source.tree.ClassTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.MethodTree;
import com.sun.source.tree.VariableTree;
import com.sun.source.util.TreePathScanner;
import com.sun.source.util.Trees;
import java.util.HashMap;
import java.util.Map;
import javax.lang.model.element.Element;
import javax.lang.model.element.ExecutableElement;
import javax.lang.model.element.TypeElement;
import org.jspecify.annotations.Nullable;

/** Documentation of classes whose source the compiler does not read along with the program. */
@FunctionalInterface
public interface ApiDocumentation {

    /**
     * Finds what is known of a class or of one of its members.
     *
     * @param className name of the class, with dollars before inner ones
     * @param key the class or member, see {@link #key}
     * @return what it does, as plain text; empty if nothing is known
     */
    String of(String className, String key);

    /**
     * Names a class or a member within its source file.
     *
     * @param element the class or member
     * @return a name such as {@code Robot.setJointSpeed/2}
     */
    static String key(Element element) {
        Element enclosing = element.getEnclosingElement();
        String owner = element instanceof TypeElement || enclosing == null ? "" : enclosing.getSimpleName() + ".";
        String count = element instanceof ExecutableElement method
                ? "/" + method.getParameters().size()
                : "";
        return owner + element.getSimpleName() + count;
    }

    /**
     * Reads the comments of a source file.
     *
     * @param unit the file
     * @param trees the compiler that has read it
     * @return plain texts by key
     */
    static Map<String, String> comments(CompilationUnitTree unit, Trees trees) {
        Collector collector = new Collector(trees);
        collector.scan(unit, "");
        return collector.comments;
    }

    /** Reads the comments of a class and its members. */
    final class Collector extends TreePathScanner<@Nullable Void, String> {

        private final Map<String, String> comments = new HashMap<>();
        private final Trees trees;

        private Collector(Trees trees) {
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
                comments.put(key, PlainJavadoc.of(comment));
            }
        }
    }
}
