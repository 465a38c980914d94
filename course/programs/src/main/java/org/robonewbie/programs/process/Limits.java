package org.robonewbie.programs.process;

/**
 * Resource limits of a program.
 *
 * @param memoryMegabytes memory for its data, which is the heap of a Java program
 * @param processorSeconds processor time of all its processes
 * @param silentSeconds longest delay of an answer in seconds: computing and sleeping time if its robots are alone on the pitch, else
 *     elapsed time
 * @param startSeconds time to connect its robots in seconds, measured in the same way
 * @param realSeconds elapsed time of a trial of two teams, and total sleeping time in other trials, in seconds
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

    /** Memory of a JVM in addition to the heap, including shared pages. */
    private static final int BESIDE_MEGABYTES = 512;

    /** Returns the limit on the resident memory of all processes. */
    long residentBytes() {
        return (memoryMegabytes + BESIDE_MEGABYTES) * 1_000_000L;
    }
}
