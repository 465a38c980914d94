package org.robonewbie.agent.log;

/** What has ended a step of a robot's program, or the whole of it. */
public final class Failure {

    /** What is said about a program that has used all memory, after what it was doing. */
    public static final String MEMORY = "has used all memory that Java has; the run ends here."
            + " Does the program keep something in each cycle and never forget it?";

    private Failure() {}

    /**
     * Finds what went wrong in the first place.
     *
     * @param thrown what was thrown
     * @return the exception in the fields of a class that could not be prepared; else what was thrown
     */
    public static Throwable rootOf(Throwable thrown) {
        Throwable cause = thrown.getCause();
        return thrown instanceof LinkageError && thrown.getMessage() == null && cause != null ? cause : thrown;
    }

    /**
     * Finds the line of the program.
     *
     * @param thrown what was thrown
     * @return such as {@code WalkToBall.java:31}; empty if only the framework is at work
     */
    public static String place(Throwable thrown) {
        return StudentCode.place(thrown.getStackTrace()).orElse("");
    }
}
