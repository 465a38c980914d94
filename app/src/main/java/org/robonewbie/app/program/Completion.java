package org.robonewbie.app.program;

import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.ErroneousTree;
import com.sun.source.tree.IdentifierTree;
import com.sun.source.tree.MemberSelectTree;
import com.sun.source.tree.Scope;
import com.sun.source.util.JavacTask;
import com.sun.source.util.TreePath;
import com.sun.source.util.TreePathScanner;
import com.sun.source.util.Trees;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Stream;
import javax.lang.model.element.Element;
import javax.lang.model.element.Modifier;
import javax.lang.model.element.PackageElement;
import javax.lang.model.element.TypeElement;
import javax.lang.model.type.DeclaredType;
import javax.lang.model.type.TypeKind;
import javax.lang.model.type.TypeMirror;
import org.jspecify.annotations.Nullable;

/** What could be written at a place of a program: the compiler reads it with a word at that place that nobody writes. */
final class Completion {

    private static final String WORD = "__here__";
    private static final int MOST = 150;

    private final JavacTask task;
    private final Trees trees;
    private final ProposalWriter writer;
    private final List<Element> found = new ArrayList<>();

    private Completion(JavacTask task) {
        this.task = task;
        this.trees = Trees.instance(task);
        this.writer = new ProposalWriter(task.getElements());
    }

    /**
     * Proposes what could be written.
     *
     * @param file where the program is
     * @param text its text
     * @param at index of the place
     * @param classPath folders and jars that it uses
     */
    static List<StudentsProgram.Proposal> at(Path file, String text, int at, List<Path> classPath) {
        int start = at;
        while (start > 0 && Character.isJavaIdentifierPart(text.charAt(start - 1))) {
            start--;
        }
        int end = at;
        while (end < text.length() && Character.isJavaIdentifierPart(text.charAt(end))) {
            end++;
        }
        String begun = text.substring(start, at);
        String asked = text.substring(0, start) + WORD + text.substring(end);
        return JavaSource.of(file, asked)
                .with(new CompilerMessages(), classPath, (task, classes) -> new Completion(task).propose(begun));
    }

    private List<StudentsProgram.Proposal> propose(String begun) throws IOException {
        CompilationUnitTree unit = task.parse().iterator().next();
        task.analyze();
        Optional<TreePath> place = Optional.ofNullable(new Finder().scan(unit, null));
        place.ifPresent(this::collect);
        String wanted = begun.toLowerCase(Locale.ROOT);
        return found.stream()
                .filter(each -> startsWith(each, wanted))
                .distinct()
                .sorted(Comparator.comparingInt(this::rank))
                .limit(MOST)
                .map(writer::write)
                .toList();
    }

    private static boolean startsWith(Element element, String wanted) {
        String name = element.getSimpleName().toString();
        return !name.contains("<")
                && !name.equals(WORD)
                && !name.isEmpty()
                && name.toLowerCase(Locale.ROOT).startsWith(wanted);
    }

    /** What all classes have comes last. */
    private int rank(Element element) {
        return element.getEnclosingElement() != null
                        && element.getEnclosingElement().toString().equals("java.lang.Object")
                ? 1
                : 0;
    }

    private void collect(TreePath place) {
        Scope scope = trees.getScope(place);
        if (place.getLeaf() instanceof MemberSelectTree select) {
            collectMembers(new TreePath(place, select.getExpression()), scope);
        } else {
            collectVisible(scope);
        }
    }

    /** What stands behind a dot. */
    private void collectMembers(TreePath expression, Scope scope) {
        Element element = trees.getElement(expression);
        TypeMirror type = trees.getTypeMirror(expression);
        if (element instanceof PackageElement inside) {
            found.addAll(inside.getEnclosedElements());
        } else if (type != null && type.getKind() != TypeKind.ERROR) {
            boolean isType = element instanceof TypeElement;
            collectMembers(
                    type,
                    scope,
                    member -> !isType
                            || member.getModifiers().contains(Modifier.STATIC)
                            || member instanceof TypeElement);
        }
    }

    private void collectMembers(TypeMirror type, Scope scope, Predicate<Element> wanted) {
        TypeMirror bound =
                type.getKind() == TypeKind.DECLARED ? type : task.getTypes().erasure(type);
        if (bound instanceof DeclaredType declared && declared.asElement() instanceof TypeElement owner) {
            task.getElements().getAllMembers(owner).stream()
                    .filter(member -> trees.isAccessible(scope, member, declared))
                    .filter(wanted)
                    .forEach(found::add);
        }
    }

    /** What can be named without a dot: variables, members of the own class, and types. */
    private void collectVisible(Scope scope) {
        for (@Nullable Scope each = scope; each != null; each = each.getEnclosingScope()) {
            each.getLocalElements().forEach(found::add);
            TypeElement owner = each.getEnclosingClass();
            if (owner != null && owner.asType() instanceof DeclaredType type) {
                collectMembers(type, scope, member -> true);
            }
        }
        collectTypes();
    }

    private void collectTypes() {
        Stream<String> framework = CompilerMessages.frameworkTypes().map(Class::getName);
        Stream<String> everyday = Stream.of("java.lang.Math", "java.lang.String", "java.lang.System", "java.util.List");
        Stream.concat(framework, everyday)
                .map(task.getElements()::getTypeElement)
                .filter(Objects::nonNull)
                .forEach(found::add);
    }

    /** Finds the word that nobody writes. */
    private static final class Finder extends TreePathScanner<@Nullable TreePath, @Nullable Void> {

        @Override
        public @Nullable TreePath visitMemberSelect(MemberSelectTree select, @Nullable Void nothing) {
            return select.getIdentifier().contentEquals(WORD)
                    ? getCurrentPath()
                    : super.visitMemberSelect(select, null);
        }

        @Override
        public @Nullable TreePath visitIdentifier(IdentifierTree identifier, @Nullable Void nothing) {
            return identifier.getName().contentEquals(WORD) ? getCurrentPath() : null;
        }

        /** A statement that is not finished yet. */
        @Override
        public @Nullable TreePath visitErroneous(ErroneousTree unfinished, @Nullable Void nothing) {
            return scan(unfinished.getErrorTrees(), null);
        }

        @Override
        public @Nullable TreePath reduce(@Nullable TreePath one, @Nullable TreePath other) {
            return one == null ? other : one;
        }
    }
}
