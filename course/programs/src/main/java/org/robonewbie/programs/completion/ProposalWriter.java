package org.robonewbie.programs.completion;

import java.util.function.BinaryOperator;
import java.util.stream.Collectors;
import javax.lang.model.element.Element;
import javax.lang.model.element.ExecutableElement;
import javax.lang.model.element.TypeElement;
import javax.lang.model.element.VariableElement;
import javax.lang.model.type.TypeMirror;
import javax.lang.model.util.Elements;

/** Converts the compiler's program elements to completion proposals. */
final class ProposalWriter {

    private final Elements elements;
    private final BinaryOperator<String> documentation;

    ProposalWriter(Elements elements, BinaryOperator<String> documentation) {
        this.elements = elements;
        this.documentation = documentation;
    }

    Proposal write(Element element) {
        String name = element.getSimpleName().toString();
        if (element instanceof ExecutableElement method) {
            String insert = method.getParameters().isEmpty() ? name + "()" : name + "(";
            String detail = "(" + parameters(method) + ") " + shortName(method.getReturnType());
            return new Proposal(name, detail, "method", insert, documentation(element));
        }
        return new Proposal(name, detail(element), kind(element), name, documentation(element));
    }

    private static String parameters(ExecutableElement method) {
        return method.getParameters().stream()
                .map(each -> shortName(each.asType()) + " " + each.getSimpleName())
                .collect(Collectors.joining(", "));
    }

    private static String detail(Element element) {
        return element instanceof VariableElement variable ? shortName(variable.asType()) : "";
    }

    private static String kind(Element element) {
        return switch (element.getKind()) {
            case ENUM_CONSTANT -> "constant";
            case FIELD -> "property";
            case CLASS, ENUM, INTERFACE, RECORD, ANNOTATION_TYPE -> "class";
            default -> "variable";
        };
    }

    /** Returns the simple name of a type. */
    private static String shortName(TypeMirror type) {
        return type.toString().replaceAll("@\\S+ ", "").replaceAll("\\b[a-z]\\w*\\.", "");
    }

    /** Returns the comment in the student's own source or, if there is none, in the packaged documentation. */
    private String documentation(Element element) {
        String own = elements.getDocComment(element);
        if (own != null) {
            return PlainJavadoc.of(own);
        }
        Element owner = element instanceof TypeElement ? element : element.getEnclosingElement();
        return owner instanceof TypeElement type
                ? documentation.apply(elements.getBinaryName(type).toString(), CommentCollector.key(element))
                : "";
    }
}
