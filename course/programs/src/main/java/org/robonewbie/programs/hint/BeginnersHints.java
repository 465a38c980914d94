package org.robonewbie.programs.hint;

import java.util.List;

/** Says what to do about what beginners stumble over most, beside the compiler's own words. */
final class BeginnersHints {

    private record Hint(String code, String text) {}

    private static final List<Hint> HINTS = List.of(
            new Hint("premature.eof", "A brace is not closed: count { and }, and add the } that is missing."),
            new Hint("unexpected.type", "Compare with ==; a single = gives a variable a value."),
            new Hint("expected", "Something is missing just before this place, often a ; or a ) at the end."),
            new Hint(
                    "not.stmt",
                    "This computes something but does nothing with it. Call a method or assign it to a variable."),
            new Hint("unclosed.str.lit", "The text needs a \" at its end, in the same line."),
            new Hint("unclosed.char.lit", "Texts stand between \" and \"; ' is for a single letter."),
            new Hint("illegal.start", "Look at the line before: is a ), a } or a ; missing there?"),
            new Hint("else.without.if", "An else follows directly after the block of its if: check ; and } before it."),
            new Hint("orphaned", "This belongs into a switch; check the braces before it."),
            new Hint(
                    "class.public.should.be.in.file",
                    "Give the class the name of its file, or the file that of its class."),
            new Hint(
                    "non-static.cant.be.ref",
                    "main belongs to no object: write this in think(), or make an object with new."),
            new Hint(
                    "incompatible.ret.type",
                    "An overriding method returns the same type as the one that it overrides."),
            new Hint(
                    "does.not.override.abstract",
                    "Write the method that is named here, with exactly these parameters."),
            new Hint(
                    "method.does.not.override.superclass",
                    "Check name and parameters of this method: nothing like it is in the class above."),
            new Hint("unreported.exception", "Surround the call with try { ... } catch (...) { ... }."),
            new Hint(
                    "var.might.not.have.been.initialized",
                    "Give the variable a value where it is declared, such as = 0."),
            new Hint("var.might.already.be.assigned", "This variable is final and has its value already."),
            new Hint("cant.assign.val", "This variable is final and keeps its value; use another one."),
            new Hint(
                    "already.defined",
                    "The name is taken in this place: leave the type away to change it, or choose another name."),
            new Hint("missing.ret.stmt", "Each way through this method needs a return with a value."),
            new Hint(
                    "missing.meth.body.or.decl.abstract",
                    "After the parentheses of a method comes { and its statements, no ;."),
            new Hint(
                    "invalid.meth.decl.ret.type.req",
                    "Write before the name what the method returns, such as void or double."),
            new Hint(
                    "unreachable.stmt", "The program never comes here: what is before it returns or repeats for ever."),
            new Hint("report.access", "This is not for other classes; look for a public method instead."),
            new Hint("cant.deref", "A plain number or truth value has no methods."),
            new Hint("incomparable.types", "These two can never be equal; compare things of the same type."),
            new Hint(
                    "operator.cant.be.applied",
                    "Check both sides: a method is called with (), and texts are compared with equals."),
            new Hint(
                    "cant.apply.symbol",
                    "Compare number, order and types of what stands in the parentheses with what is required."),
            new Hint(
                    "cant.resolve",
                    "Java does not know this name here: check spelling and capitals, or declare it first."),
            new Hint("doesnt.exist", "Check the spelling of the import."));

    private static final String WRONG_TYPE = "prob.found.req";
    private static final String ASSIGNMENT = "A value of this type does not fit here. A condition compares with ==,"
            + " and a double becomes a whole number by (int).";

    private BeginnersHints() {}

    /**
     * Returns what to do.
     *
     * @param code the compiler's name of the mistake
     * @param place what it has underlined
     * @return a sentence or two; empty if nothing is to be added
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
