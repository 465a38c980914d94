package org.robonewbie.programs;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Compact source file: a {@code void main()} without a class, which Java 25 permits (JEP 512). */
final class CompactSource {

    /** Comments and literals, whose braces do not count. */
    private static final Pattern OPAQUE = Pattern.compile(
            "//[^\\n]*|/\\*.*?\\*/|\"\"\".*?\"\"\"|\"(?:\\\\.|[^\"\\\\\\n])*\"|'(?:\\\\.|[^'\\\\\\n])*'",
            Pattern.DOTALL);

    private static final Pattern BLOCK = Pattern.compile("\\{[^{}]*}");
    private static final Pattern MAIN = Pattern.compile("\\bvoid\\s+main\\s*\\(");

    private CompactSource() {}

    /**
     * Explains why this Java cannot run a file.
     *
     * @param text the source file
     * @param className the simple name of the expected class
     * @return the reason and a remedy; empty if the file has a class or this Java supports the form
     */
    static Optional<String> trouble(String text, String className) {
        return trouble(text, className, Runtime.version().feature());
    }

    static Optional<String> trouble(String text, String className, int javaVersion) {
        return javaVersion < Program.JAVA_OF_SHORT_FORMS && is(text, className)
                ? Optional.of(needsNewerJava("A file whose main method is outside of a class", javaVersion)
                        + ", or write: public class " + className
                        + " { public static void main(String[] args) { ... } }")
                : Optional.empty();
    }

    /** The beginning of a sentence about a form that only newer versions of Java support. */
    static String needsNewerJava(String what, int javaVersion) {
        return what + " needs Java " + Program.JAVA_OF_SHORT_FORMS + " or newer, and this is Java " + javaVersion
                + ". Install a JDK " + Program.JAVA_OF_SHORT_FORMS + ", for example from https://adoptium.net";
    }

    /** With a surplus brace, a main method seems to be outside of its class; but then a class precedes it. */
    private static boolean is(String text, String className) {
        String code = OPAQUE.matcher(text).replaceAll(" ");
        for (String outer = ""; !outer.equals(code); ) {
            outer = code;
            code = BLOCK.matcher(code).replaceAll(";");
        }
        Matcher main = MAIN.matcher(code);
        boolean hasClass = Pattern.compile("\\b(?:class|record|enum|interface)\\s+" + Pattern.quote(className) + "\\b")
                .matcher(code)
                .find();
        return main.find() && !hasClass && code.lastIndexOf('{', main.start()) < 0;
    }
}
