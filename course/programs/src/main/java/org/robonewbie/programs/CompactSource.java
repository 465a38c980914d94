package org.robonewbie.programs;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** A source file without a class: its {@code void main()} stands alone, as Java 25 permits (JEP 512). */
final class CompactSource {

    /** Comments, texts and single letters, in which braces mean nothing. */
    private static final Pattern OPAQUE = Pattern.compile(
            "//[^\\n]*|/\\*.*?\\*/|\"\"\".*?\"\"\"|\"(?:\\\\.|[^\"\\\\\\n])*\"|'(?:\\\\.|[^'\\\\\\n])*'",
            Pattern.DOTALL);

    private static final Pattern BLOCK = Pattern.compile("\\{[^{}]*}");
    private static final Pattern MAIN = Pattern.compile("\\bvoid\\s+main\\s*\\(");

    private CompactSource() {}

    /**
     * Explains why an older Java cannot run a file.
     *
     * @param text the source file
     * @param className the simple name of the class that it should have
     * @return a sentence with what to do; empty if the file has a class or this Java knows the form
     */
    static Optional<String> trouble(String text, String className) {
        return trouble(text, className, Runtime.version().feature());
    }

    static Optional<String> trouble(String text, String className, int javaVersion) {
        return javaVersion < Program.JAVA_OF_SHORT_FORMS && is(text, className)
                ? Optional.of(needsNewerJava("A file whose main method stands outside of a class", javaVersion)
                        + ", or write: public class " + className
                        + " { public static void main(String[] args) { ... } }")
                : Optional.empty();
    }

    /** A sentence without its end about a form that only newer Javas know. */
    static String needsNewerJava(String what, int javaVersion) {
        return what + " needs Java " + Program.JAVA_OF_SHORT_FORMS + " or newer, and this is Java " + javaVersion
                + ". Install a JDK " + Program.JAVA_OF_SHORT_FORMS + ", for example from https://adoptium.net";
    }

    /** With a brace too many, a main method seems to stand alone too; but then there is a class before it. */
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
