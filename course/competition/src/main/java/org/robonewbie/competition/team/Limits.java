package org.robonewbie.competition.team;

/**
 * What a team's program may use in one trial.
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

    /** The usual limits. */
    public static final Limits USUAL = new Limits(512, 300, 20, 60, 900);

    /** What a Java program needs in addition to its data, and what may be shared with other programs. */
    private static final int BESIDE_MEGABYTES = 512;

    /** The memory that all processes of a team may take. */
    long residentBytes() {
        return (memoryMegabytes + BESIDE_MEGABYTES) * 1_000_000L;
    }
}
