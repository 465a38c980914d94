package org.robonewbie.programs;

/** Java files do not compile; the compiler has shown where. */
public final class CompilationFailedException extends RuntimeException {

    private static final long serialVersionUID = 1;

    CompilationFailedException(String message) {
        super(message);
    }
}
