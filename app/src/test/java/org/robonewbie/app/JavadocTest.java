package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.source.doctree.DocCommentTree;
import com.sun.source.doctree.ParamTree;
import com.sun.source.doctree.ReturnTree;
import com.sun.source.tree.ClassTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.MethodTree;
import com.sun.source.tree.ModifiersTree;
import com.sun.source.tree.Tree;
import com.sun.source.tree.VariableTree;
import com.sun.source.util.DocTrees;
import com.sun.source.util.JavacTask;
import com.sun.source.util.TreePath;
import com.sun.source.util.TreePathScanner;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Collectors;
import javax.lang.model.element.Modifier;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Public types have a comment. In the packages of the API everything public has one: methods with each parameter and what they return,
 * and constants. Overriding methods and compact constructors of records inherit theirs.
 */
class JavadocTest {

    @Test
    void everythingPublicIsDocumented() throws IOException {
        assertThat(missing(Project.productSources(".java"))).isEmpty();
    }

    @Test
    void internalPackagesDocumentTheirTypes(@TempDir Path folder) throws IOException {
        Files.writeString(folder.resolve("package-info.java"), "/** <strong>Internal</strong>. */ package inside;");
        Path file = Files.writeString(
                folder.resolve("Quiet.java"),
                "public class Quiet { public int half(int angle) { return angle / 2; } }");

        assertThat(missing(List.of(file)))
                .extracting(line -> line.replaceFirst(".*: ", ""))
                .containsExactly("Quiet has no comment");
    }

    @Test
    void missingWordsAreFound(@TempDir Path folder) throws IOException {
        Path file = Files.writeString(folder.resolve("Quiet.java"), """
                public class Quiet {
                    /** Says a bit. */
                    public int half(int angle) {
                        return angle;
                    }

                    void inside() {}

                    public record Pair(int a) {}

                    enum Inside { SMALL }

                    public static final int NUMBER = 1;
                }
                """);

        assertThat(missing(List.of(file)))
                .extracting(line -> line.replaceFirst(".*: ", ""))
                .containsExactly(
                        "Quiet has no comment",
                        "half(1) says nothing of angle",
                        "half(1) does not say what it returns",
                        "Pair has no comment",
                        "NUMBER has no comment");
    }

    private static List<String> missing(List<Path> files) throws IOException {
        var compiler = ToolProvider.getSystemJavaCompiler();
        try (StandardJavaFileManager disk = compiler.getStandardFileManager(null, null, StandardCharsets.UTF_8)) {
            JavacTask task = (JavacTask) compiler.getTask(
                    null, disk, null, List.of("-proc:none"), null, disk.getJavaFileObjectsFromPaths(files));
            Reader reader = new Reader(DocTrees.instance(task));
            for (CompilationUnitTree unit : task.parse()) {
                reader.scan(unit, null);
            }
            return reader.missing;
        }
    }

    /** Walks through what others can see and notes what says nothing. */
    private static final class Reader extends TreePathScanner<@Nullable Void, @Nullable Void> {

        private final List<String> missing = new ArrayList<>();
        private final DocTrees comments;
        private boolean isInternal;

        Reader(DocTrees comments) {
            this.comments = comments;
        }

        @Override
        public @Nullable Void visitCompilationUnit(CompilationUnitTree unit, @Nullable Void nothing) {
            Path about = Path.of(unit.getSourceFile().toUri()).resolveSibling("package-info.java");
            isInternal = Files.exists(about) && Project.read(about).contains("<strong>Internal</strong>");
            return super.visitCompilationUnit(unit, null);
        }

        @Override
        public @Nullable Void visitClass(ClassTree type, @Nullable Void nothing) {
            if (!isVisible(type.getModifiers())) {
                return null;
            }
            DocCommentTree comment = comment();
            note(comment == null, type.getSimpleName() + " has no comment");
            if (comment != null && !isInternal && type.getKind() == Tree.Kind.RECORD) {
                noteParameters(type.getSimpleName().toString(), comment, components(type));
            }
            return super.visitClass(type, null);
        }

        @Override
        public @Nullable Void visitMethod(MethodTree method, @Nullable Void nothing) {
            boolean hasOwnComment = !hasAnnotation(method.getModifiers(), "Override") && !isOfRecord(method);
            if (!isInternal && isVisible(method.getModifiers()) && hasOwnComment) {
                noteMethod(method);
            }
            return null;
        }

        @Override
        public @Nullable Void visitVariable(VariableTree field, @Nullable Void nothing) {
            note(
                    !isInternal && isVisible(field.getModifiers()) && comment() == null && !isOfRecord(field),
                    field.getName() + " has no comment");
            return null;
        }

        private void noteMethod(MethodTree method) {
            String name = method.getName() + "(" + method.getParameters().size() + ")";
            DocCommentTree comment = comment();
            if (comment == null) {
                note(true, name + " has no comment");
                return;
            }
            noteParameters(
                    name,
                    comment,
                    method.getParameters().stream()
                            .map(parameter -> parameter.getName().toString())
                            .collect(Collectors.toSet()));
            Tree returned = method.getReturnType();
            boolean returnsNothing = returned == null || returned.toString().equals("void");
            note(!returnsNothing && !tellsReturn(comment), name + " does not say what it returns");
        }

        private void noteParameters(String name, DocCommentTree comment, Set<String> parameters) {
            Set<String> told = comment.getBlockTags().stream()
                    .filter(ParamTree.class::isInstance)
                    .map(tag -> ((ParamTree) tag).getName().toString())
                    .collect(Collectors.toSet());
            parameters.stream()
                    .filter(parameter -> !told.contains(parameter))
                    .forEach(parameter -> note(true, name + " says nothing of " + parameter));
        }

        private static boolean tellsReturn(DocCommentTree comment) {
            return comment.getBlockTags().stream().anyMatch(ReturnTree.class::isInstance)
                    || comment.getFirstSentence().stream().anyMatch(ReturnTree.class::isInstance);
        }

        private static Set<String> components(ClassTree type) {
            return type.getMembers().stream()
                    .filter(VariableTree.class::isInstance)
                    .map(VariableTree.class::cast)
                    .filter(field -> !field.getModifiers().getFlags().contains(Modifier.STATIC))
                    .map(field -> field.getName().toString())
                    .collect(Collectors.toSet());
        }

        private @Nullable DocCommentTree comment() {
            return comments.getDocCommentTree(getCurrentPath());
        }

        /** Whether something can be seen from outside; members of interfaces always can. */
        private boolean isVisible(ModifiersTree modifiers) {
            Set<Modifier> flags = modifiers.getFlags();
            if (flags.contains(Modifier.PUBLIC) || flags.contains(Modifier.PROTECTED)) {
                return true;
            }
            TreePath parent = Objects.requireNonNull(getCurrentPath().getParentPath());
            return parent.getLeaf().getKind() == Tree.Kind.INTERFACE && !flags.contains(Modifier.PRIVATE);
        }

        /** Components and compact constructors are told in the comment of the record, accessors say what they are. */
        private boolean isOfRecord(Tree member) {
            Tree parent =
                    Objects.requireNonNull(getCurrentPath().getParentPath()).getLeaf();
            boolean isConstructor =
                    member instanceof MethodTree method && method.getName().contentEquals("<init>");
            boolean isComponent = member instanceof VariableTree field
                    && !field.getModifiers().getFlags().contains(Modifier.STATIC);
            return parent.getKind() == Tree.Kind.RECORD && (isConstructor || isComponent);
        }

        private static boolean hasAnnotation(ModifiersTree modifiers, String name) {
            return modifiers.getAnnotations().stream()
                    .anyMatch(annotation ->
                            annotation.getAnnotationType().toString().equals(name));
        }

        private void note(boolean isMissing, String what) {
            if (isMissing) {
                Path file = Path.of(
                        getCurrentPath().getCompilationUnit().getSourceFile().toUri());
                missing.add(Project.ROOT.relativize(file) + ": " + what);
            }
        }
    }
}
