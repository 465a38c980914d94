package org.robonewbie.programs;

import java.util.Optional;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;

/** Provides the compiler of the Java installation that runs RoboNewbie. Only a JDK contains a compiler; a JRE does not. */
public final class CompilerOfThisJava {

    private CompilerOfThisJava() {}

    /** {@return whether this installation contains a compiler} */
    public static boolean isThere() {
        try {
            return find().isPresent();
        } catch (NoClassDefFoundError withoutModule) {
            return false; // the installation lacks the module java.compiler
        }
    }

    /**
     * Requires a compiler. Call before any use of {@code javax.tools}.
     *
     * @throws CalledWronglyException if this installation does not contain a compiler
     */
    static void require() {
        if (!isThere()) {
            throw new CalledWronglyException(
                    "To run .java files, install a JDK instead of a Java runtime (JRE): this Java installation has no"
                            + " compiler ("
                            + System.getProperty("java.home") + ").");
        }
    }

    /** {@return the compiler} */
    static JavaCompiler get() {
        return find().orElseThrow();
    }

    private static Optional<JavaCompiler> find() {
        return Optional.ofNullable(ToolProvider.getSystemJavaCompiler());
    }
}
