package org.robonewbie.programs;

/** Thrown when Java files do not compile. The errors have been printed. */
public final class CompilationFailedException extends RuntimeException {

    private static final long serialVersionUID = 1;

    CompilationFailedException(String message) {
        super(message);
    }
}
