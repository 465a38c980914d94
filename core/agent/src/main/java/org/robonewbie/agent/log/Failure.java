package org.robonewbie.agent.log;

/** Analysis of an exception that ended a step of a robot program, or the whole program. */
public final class Failure {

    /** Message about a program that has exhausted the heap, phrased to follow the name of the failed step. */
    public static final String MEMORY = "ran out of memory; the run ends here. Does a list or map grow in every cycle?";

    private Failure() {}

    /**
     * Returns the root cause of a failed class initialisation.
     *
     * @param thrown the exception
     * @return the exception thrown by a static initialiser; otherwise {@code thrown} itself
     */
    public static Throwable rootOf(Throwable thrown) {
        Throwable cause = thrown.getCause();
        return thrown instanceof LinkageError && thrown.getMessage() == null && cause != null ? cause : thrown;
    }

    /**
     * Returns the program line that failed.
     *
     * @param thrown the exception
     * @return file and line, such as {@code WalkToBall.java:31}; empty if only the framework was running
     */
    public static String place(Throwable thrown) {
        return StudentCode.place(thrown.getStackTrace()).orElse("");
    }
}
