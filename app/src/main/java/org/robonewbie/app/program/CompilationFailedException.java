package org.robonewbie.app.program;

/** A Java file of the user does not compile; the compiler has shown where. */
final class CompilationFailedException extends RuntimeException {

    CompilationFailedException(String message) {
        super(message);
    }
}
