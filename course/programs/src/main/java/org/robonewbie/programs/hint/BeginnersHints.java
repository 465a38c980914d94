package org.robonewbie.programs.hint;

import java.util.List;

/** Advice on the compiler errors that beginners encounter most often. */
final class BeginnersHints {

    private record Hint(String code, String text) {}

    private static final List<Hint> HINTS = List.of(
            new Hint("premature.eof", "A brace is not closed: count { and }, and add the } that is missing."),
            new Hint("unexpected.type", "Compare with ==; a single = assigns a value to a variable."),
            new Hint("expected", "Something is missing just before this point, often a ; or a ) at the end."),
            new Hint(
                    "not.stmt",
                    "This computes something but does nothing with it. Call a method or assign it to a variable."),
            new Hint("unclosed.str.lit", "The string needs a \" at its end, on the same line."),
            new Hint("unclosed.char.lit", "Write strings between \" and \"; ' is for a single character."),
            new Hint("illegal.start", "Look at the line before: is a ), a } or a ; missing there?"),
            new Hint(
                    "else.without.if",
                    "An else must follow directly after the block of its if: check ; and } before it."),
            new Hint("orphaned", "This belongs in a switch; check the braces before it."),
            new Hint(
                    "class.public.should.be.in.file",
                    "Rename the class to match its file, or the file to match its class."),
            new Hint(
                    "non-static.cant.be.ref",
                    "main belongs to no object: write this in think(), or make an object with new."),
            new Hint(
                    "incompatible.ret.type",
                    "An overriding method must return the same type as the method it overrides."),
            new Hint("does.not.override.abstract", "Write the method named here, with exactly these parameters."),
            new Hint(
                    "method.does.not.override.superclass",
                    "Check the name and parameters of this method: the superclass has no such method."),
            new Hint("unreported.exception", "Surround the call with try { ... } catch (...) { ... }."),
            new Hint(
                    "var.might.not.have.been.initialized",
                    "Give the variable a value where it is declared, such as = 0."),
            new Hint("var.might.already.be.assigned", "This variable is final and already has a value."),
            new Hint("cant.assign.val", "This variable is final and cannot be changed; use another one."),
            new Hint(
                    "already.defined",
                    "This name is already in use here: omit the type to assign to it, or choose another name."),
            new Hint("missing.ret.stmt", "Every path through this method must return a value."),
            new Hint(
                    "missing.meth.body.or.decl.abstract",
                    "The parentheses of a method are followed by { and its statements, not by ;."),
            new Hint(
                    "invalid.meth.decl.ret.type.req",
                    "Write the return type before the method's name, such as void or double."),
            new Hint(
                    "unreachable.stmt",
                    "The program never reaches this line: the code before it returns or loops forever."),
            new Hint("report.access", "Other classes cannot access this; look for a public method instead."),
            new Hint("cant.deref", "A primitive number or boolean has no methods."),
            new Hint("incomparable.types", "These two can never be equal; compare values of the same type."),
            new Hint(
                    "operator.cant.be.applied",
                    "Check both sides: call a method with (), and compare strings with equals."),
            new Hint("cant.apply.symbol", "Compare the number, order and types of the arguments with those required."),
            new Hint(
                    "cant.resolve",
                    "Java does not recognise this name here: check its spelling and capitalisation, or declare it first."),
            new Hint("doesnt.exist", "Check the spelling of the import."));

    private static final String WRONG_TYPE = "prob.found.req";
    private static final String ASSIGNMENT = "A value of this type does not fit here. Compare with ==,"
            + " and convert a double to an integer with (int).";

    private BeginnersHints() {}

    /**
     * Returns advice for an error.
     *
     * @param code the compiler's error code
     * @param place the underlined text
     * @return one or two sentences; empty if there is no advice
     */
    static String of(String code, String place) {
        if (code.contains(WRONG_TYPE)) {
            return place.equals("return") ? "A void method returns nothing." : ASSIGNMENT;
        }
        return HINTS.stream()
                .filter(hint -> code.contains(hint.code))
                .map(Hint::text)
                .findFirst()
                .orElse("");
    }
}
