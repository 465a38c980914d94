package org.robonewbie.programs;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Compact source file: a {@code void main()} without a class, which Java 25 permits (JEP 512). */
final class CompactSource {

    /** Matches comments and literals, in which braces have no meaning. */
    private static final Pattern OPAQUE = Pattern.compile(
            "//[^\\n]*|/\\*.*?\\*/|\"\"\".*?\"\"\"|\"(?:\\\\.|[^\"\\\\\\n])*\"|'(?:\\\\.|[^'\\\\\\n])*'",
            Pattern.DOTALL);

    private static final Pattern BLOCK = Pattern.compile("\\{[^{}]*}");
    private static final Pattern MAIN = Pattern.compile("\\bvoid\\s+main\\s*\\(");

    private CompactSource() {}

    /**
     * Returns the reason why this version of Java cannot run a file.
     *
     * @param text the source file
     * @param className the simple name of the expected class
     * @return the reason and what to do about it; empty if the file has a class or this version of Java supports compact
     *     source files
     */
    static Optional<String> trouble(String text, String className) {
        return trouble(text, className, Runtime.version().feature());
    }

    static Optional<String> trouble(String text, String className, int javaVersion) {
        return javaVersion < Program.JAVA_OF_SHORT_FORMS && is(text, className)
                ? Optional.of(needsNewerJava("A file whose main method is outside a class", javaVersion)
                        + ", or write: public class " + className
                        + " { public static void main(String[] args) { ... } }")
                : Optional.empty();
    }

    /** Returns a sentence, without the full stop, about the version of Java that a feature needs. */
    static String needsNewerJava(String what, int javaVersion) {
        return what + " needs Java " + Program.JAVA_OF_SHORT_FORMS + " or newer, but this is Java " + javaVersion
                + ". Install JDK " + Program.JAVA_OF_SHORT_FORMS + ", for example from https://adoptium.net";
    }

    /**
     * Returns whether source code is a compact source file. Code with a class before the main method does not count,
     * because a surplus brace may merely make the method appear to be outside the class.
     */
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
