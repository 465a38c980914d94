package org.robonewbie.competition.team;

/**
 * What a team's program may use in one trial.
 *
 * @param memoryMegabytes memory for its data; a Java program gets this much heap
 * @param processorSeconds processor time of all its processes
 * @param silentSeconds real seconds for which it may keep the world waiting
 * @param startSeconds real seconds that it may need to bring its robots
 * @param realSeconds real seconds that the trial may take
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
