package org.robonewbie.programs.completion;

import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.util.Trees;
import java.util.Map;
import javax.lang.model.element.Element;
import javax.lang.model.element.ExecutableElement;
import javax.lang.model.element.TypeElement;

/** Documentation of classes whose sources are not compiled together with the program. */
@FunctionalInterface
public interface ApiDocumentation {

    /**
     * Finds the documentation of a class or member.
     *
     * @param className binary name of the class
     * @param key the class or member, see {@link #key}
     * @return plain text; empty if there is none
     */
    String of(String className, String key);

    /**
     * Returns the key of a class or member within its source file.
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
     * Extracts the documentation comments of a source file.
     *
     * @param unit the file
     * @param trees the compiler that has parsed it
     * @return plain texts by key
     */
    static Map<String, String> comments(CompilationUnitTree unit, Trees trees) {
        return CommentCollector.read(unit, trees);
    }
}
