package org.robonewbie.simulator.physics.sparse;

/**
 * Growth policy of a scratch array that is reused for islands of all sizes: it grows immediately, but shrinks only after
 * it has been oversized for many consecutive islands.
 */
final class ScratchCapacity {

    private static final int MAX_OVERSIZED_ISLANDS = 2_000;
    private static final int OVERSIZE_FACTOR = 4;

    private final int minLength;
    private int oversizedIslands;

    ScratchCapacity(int minLength) {
        this.minLength = minLength;
    }

    /**
     * Chooses the length of the array.
     *
     * @param length current length
     * @param needed length required by the next island
     * @return the current length if the array can be kept, otherwise the length of a new array, at least {@code needed}
     */
    int fit(int length, int needed) {
        boolean oversized = length > minLength && needed < length / OVERSIZE_FACTOR;
        oversizedIslands = oversized ? oversizedIslands + 1 : 0;
        if (needed <= length && oversizedIslands < MAX_OVERSIZED_ISLANDS) {
            return length;
        }
        oversizedIslands = 0;
        return Math.max(minLength, needed + needed / 2);
    }
}
