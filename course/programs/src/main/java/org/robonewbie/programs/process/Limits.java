package org.robonewbie.programs.process;

/**
 * What a program may use.
 *
 * @param memoryMegabytes memory for its data; a Java program gets this much heap
 * @param processorSeconds processor time of all its processes
 * @param silentSeconds seconds for which it may keep the world waiting: while its robot is alone on the pitch, those in which
 *     it calculates or sleeps, else real ones
 * @param startSeconds seconds that it may need to bring its robots, counted in the same way
 * @param realSeconds real seconds that a trial of two teams may take, and that a program may sleep on its turns in another one
 */
public record Limits(
        int memoryMegabytes, double processorSeconds, double silentSeconds, double startSeconds, double realSeconds) {

    /** The limits of a trial of a contest, if no others are wanted. */
    public static final Limits DEFAULT = new Limits(JavaCommand.MEGABYTES, 300, 20, 60, 900);

    /** No limit but memory and the number of processes: others watch the time. */
    static final Limits UNTIMED = new Limits(
            JavaCommand.MEGABYTES,
            Double.POSITIVE_INFINITY,
            Double.POSITIVE_INFINITY,
            Double.POSITIVE_INFINITY,
            Double.POSITIVE_INFINITY);

    /** No limits: a program that its own author runs. */
    public static final Limits NONE = new Limits(Integer.MAX_VALUE, 0, 0, 0, 0);

    /** What a Java program needs in addition to its data, and what may be shared with other programs. */
    private static final int BESIDE_MEGABYTES = 512;

    /** The memory that all processes of a program may take. */
    long residentBytes() {
        return (memoryMegabytes + BESIDE_MEGABYTES) * 1_000_000L;
    }
}
