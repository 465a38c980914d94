package org.robonewbie.programs.process;

/**
 * Resource limits of a program.
 *
 * @param memoryMegabytes memory for the program's data in megabytes; for a Java program, the heap size
 * @param processorSeconds processor time of all processes of the program, in seconds
 * @param silentSeconds maximum response time in seconds, measured as computing and sleeping time if the program's robots
 *     are alone on the pitch, otherwise as elapsed time
 * @param startSeconds maximum time for connecting the robots, in seconds, measured in the same way
 * @param realSeconds maximum elapsed time of a trial with two teams, and maximum total sleeping time in other trials, in
 *     seconds
 */
public record Limits(
        int memoryMegabytes, double processorSeconds, double silentSeconds, double startSeconds, double realSeconds) {

    /** Default limits of a trial in a contest. */
    public static final Limits DEFAULT = new Limits(JavaCommand.MEGABYTES, 300, 20, 60, 900);

    /** Limits on memory and the number of processes, without time limits. */
    static final Limits UNTIMED = new Limits(
            JavaCommand.MEGABYTES,
            Double.POSITIVE_INFINITY,
            Double.POSITIVE_INFINITY,
            Double.POSITIVE_INFINITY,
            Double.POSITIVE_INFINITY);

    /** No limits, for a program run by its author. */
    public static final Limits NONE = new Limits(Integer.MAX_VALUE, 0, 0, 0, 0);

    /** Memory in megabytes that a JVM needs in addition to the heap, including shared pages. */
    private static final int BESIDE_MEGABYTES = 512;

    /** Returns the limit on the total resident memory of all processes. */
    long residentBytes() {
        return (memoryMegabytes + BESIDE_MEGABYTES) * 1_000_000L;
    }
}
