package org.robonewbie.programs;

import java.util.Optional;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;

/** The compiler of the Java that runs RoboNewbie: a JDK has one, a run-time (JRE) has none. */
public final class CompilerOfThisJava {

    private CompilerOfThisJava() {}

    /** {@return whether there is one} */
    public static boolean isThere() {
        try {
            return find().isPresent();
        } catch (NoClassDefFoundError withoutModule) {
            return false; // a Java that was made smaller lacks even the class that is asked
        }
    }

    /**
     * Requires a compiler, before anything of {@code javax.tools} is touched.
     *
     * @throws CalledWronglyException if there is none
     */
    static void require() {
        if (!isThere()) {
            throw new CalledWronglyException(
                    "To run .java files install a JDK instead of a Java run-time (JRE): this Java has no compiler ("
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
