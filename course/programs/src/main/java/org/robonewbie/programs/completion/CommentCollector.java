package org.robonewbie.programs.completion;

import com.sun.source.tree.ClassTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.MethodTree;
import com.sun.source.tree.VariableTree;
import com.sun.source.util.TreePathScanner;
import com.sun.source.util.Trees;
import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** Tree scanner that collects the documentation comments of classes and members. */
final class CommentCollector extends TreePathScanner<@Nullable Void, String> {

    private final Map<String, String> comments = new HashMap<>();
    private final Trees trees;

    private CommentCollector(Trees trees) {
        this.trees = trees;
    }

    /** {@return plain texts by key, see {@link ApiDocumentation#key}} */
    static Map<String, String> read(CompilationUnitTree unit, Trees trees) {
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
}
