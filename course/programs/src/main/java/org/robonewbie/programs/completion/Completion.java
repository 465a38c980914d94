package org.robonewbie.programs.completion;

import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.ErroneousTree;
import com.sun.source.tree.IdentifierTree;
import com.sun.source.tree.MemberSelectTree;
import com.sun.source.tree.Scope;
import com.sun.source.util.TreePath;
import com.sun.source.util.TreePathScanner;
import com.sun.source.util.Trees;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.function.BinaryOperator;
import java.util.function.Predicate;
import java.util.stream.Stream;
import javax.lang.model.element.Element;
import javax.lang.model.element.Modifier;
import javax.lang.model.element.PackageElement;
import javax.lang.model.element.TypeElement;
import javax.lang.model.type.DeclaredType;
import javax.lang.model.type.TypeKind;
import javax.lang.model.type.TypeMirror;
import javax.lang.model.util.Elements;
import javax.lang.model.util.Types;
import org.jspecify.annotations.Nullable;

/** Code completion based on the compiler's syntax tree, in which a placeholder marks the cursor. */
public final class Completion {

    private static final int MAX_PROPOSALS = 150;

    private final Compiler compiler;
    private final List<Element> found = new ArrayList<>();

    private Completion(Compiler compiler) {
        this.compiler = compiler;
    }

    /**
     * Utilities of the compiler that has analysed the program.
     *
     * @param trees utility for syntax trees
     * @param elements utility for classes and members
     * @param types utility for types
     */
    public record Compiler(Trees trees, Elements elements, Types types) {}

    /**
     * Returns completion proposals.
     *
     * @param compiler the compiler, which has analysed the program with a {@link PartialWord}
     * @param unit the file that contains the cursor
     * @param begun the part of the identifier before the cursor
     * @param documentation looks up the documentation of a member outside the program by class name and key; see {@link
     *     CommentCollector}
     * @param typeNames full names of classes that are proposed where a type is expected
     * @return the proposals, the most likely ones first
     */
    public static List<Proposal> of(
            Compiler compiler,
            CompilationUnitTree unit,
            String begun,
            BinaryOperator<String> documentation,
            Collection<String> typeNames) {
        Completion completion = new Completion(compiler);
        Optional.ofNullable(new Finder().scan(unit, null)).ifPresent(place -> completion.collect(place, typeNames));
        ProposalWriter writer = new ProposalWriter(compiler.elements(), documentation);
        String wanted = begun.toLowerCase(Locale.ROOT);
        return completion.found.stream()
                .filter(each -> startsWith(each, wanted))
                .distinct()
                .sorted(Comparator.comparingInt(Completion::rank))
                .limit(MAX_PROPOSALS)
                .map(writer::write)
                .toList();
    }

    private static boolean startsWith(Element element, String wanted) {
        String name = element.getSimpleName().toString();
        return !name.contains("<")
                && !name.equals(PartialWord.STAND_IN)
                && !name.isEmpty()
                && name.toLowerCase(Locale.ROOT).startsWith(wanted);
    }

    /** Returns the sort rank of a member; members of {@code Object} are last. */
    private static int rank(Element element) {
        return element.getEnclosingElement() != null
                        && element.getEnclosingElement().toString().equals("java.lang.Object")
                ? 1
                : 0;
    }

    private void collect(TreePath place, Collection<String> typeNames) {
        Scope scope = compiler.trees.getScope(place);
        if (place.getLeaf() instanceof MemberSelectTree select) {
            collectMembers(new TreePath(place, select.getExpression()), scope);
        } else {
            collectVisible(scope);
            collectTypes(typeNames);
        }
    }

    /** Collects the members that may follow a dot. */
    private void collectMembers(TreePath expression, Scope scope) {
        Element element = compiler.trees.getElement(expression);
        TypeMirror type = compiler.trees.getTypeMirror(expression);
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
        TypeMirror bound = type.getKind() == TypeKind.DECLARED ? type : compiler.types.erasure(type);
        if (bound instanceof DeclaredType declared && declared.asElement() instanceof TypeElement owner) {
            compiler.elements.getAllMembers(owner).stream()
                    .filter(member -> compiler.trees.isAccessible(scope, member, declared))
                    .filter(wanted)
                    .forEach(found::add);
        }
    }

    /** Collects everything that can be used without qualification: variables, members of the enclosing classes, and types. */
    private void collectVisible(Scope scope) {
        for (@Nullable Scope each = scope; each != null; each = each.getEnclosingScope()) {
            each.getLocalElements().forEach(found::add);
            TypeElement owner = each.getEnclosingClass();
            if (owner != null && owner.asType() instanceof DeclaredType type) {
                collectMembers(type, scope, member -> true);
            }
        }
    }

    private void collectTypes(Collection<String> typeNames) {
        Stream<String> everyday = Stream.of("java.lang.Math", "java.lang.String", "java.lang.System", "java.util.List");
        Stream.concat(typeNames.stream(), everyday)
                .map(compiler.elements::getTypeElement)
                .filter(Objects::nonNull)
                .forEach(found::add);
    }

    /** Finds the placeholder in the syntax tree. */
    private static final class Finder extends TreePathScanner<@Nullable TreePath, @Nullable Void> {

        @Override
        public @Nullable TreePath visitMemberSelect(MemberSelectTree select, @Nullable Void nothing) {
            return select.getIdentifier().contentEquals(PartialWord.STAND_IN)
                    ? getCurrentPath()
                    : super.visitMemberSelect(select, null);
        }

        @Override
        public @Nullable TreePath visitIdentifier(IdentifierTree identifier, @Nullable Void nothing) {
            return identifier.getName().contentEquals(PartialWord.STAND_IN) ? getCurrentPath() : null;
        }

        /** Also scans the contents of an incomplete statement. */
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
