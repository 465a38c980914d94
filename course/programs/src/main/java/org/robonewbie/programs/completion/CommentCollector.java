package org.robonewbie.programs.completion;

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

/** Syntax tree scanner that collects the documentation comments of classes and members. */
public final class CommentCollector extends TreePathScanner<@Nullable Void, String> {

    private final Map<String, String> comments = new HashMap<>();
    private final Trees trees;

    private CommentCollector(Trees trees) {
        this.trees = trees;
    }

    /**
     * Returns the documentation comments of a source file.
     *
     * @param unit the file
     * @param trees the syntax trees of the compiler that has parsed the file
     * @return the comments as plain text, by key, such as {@code Robot.setJointSpeed/2}
     */
    public static Map<String, String> read(CompilationUnitTree unit, Trees trees) {
        CommentCollector collector = new CommentCollector(trees);
        collector.scan(unit, "");
        return collector.comments;
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

    /** Returns the key of a class or member within its source file. */
    static String key(Element element) {
        Element enclosing = element.getEnclosingElement();
        String owner = element instanceof TypeElement || enclosing == null ? "" : enclosing.getSimpleName() + ".";
        String count = element instanceof ExecutableElement method
                ? "/" + method.getParameters().size()
                : "";
        return owner + element.getSimpleName() + count;
    }
}
