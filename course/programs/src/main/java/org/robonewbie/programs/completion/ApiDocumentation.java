package org.robonewbie.programs.completion;

import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.util.Trees;
import java.util.Map;
import javax.lang.model.element.Element;
import javax.lang.model.element.ExecutableElement;
import javax.lang.model.element.TypeElement;

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
        return CommentCollector.read(unit, trees);
    }
}
