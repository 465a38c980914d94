package org.robonewbie.competition.contest;

import java.util.Map;
import java.util.Random;

/**
 * What differs from one competition to the next.
 *
 * @param seed seed of all random numbers
 * @param varied whether start places depend on the seed, so that no team can prepare for them
 * @param ownSeeds seeds of teams that, to try something out, play under random conditions of their own
 */
public record Conditions(long seed, boolean varied, Map<String, Long> ownSeeds) {

    private static final double VARIED_METRES = 0.3;
    private static final double VARIED_DEGREES = 20;

    /** Makes the map unmodifiable. */
    public Conditions {
        ownSeeds = Map.copyOf(ownSeeds);
    }

    /**
     * Returns the usual conditions.
     *
     * @param seed seed of all random numbers
     * @return equal ones for all, the usual start places
     */
    public static Conditions of(long seed) {
        return new Conditions(seed, false, Map.of());
    }

    /** The usual start place, or, if places vary, another one for each seed; it is the same for all teams. */
    StartPlace start(StartPlace usual) {
        if (!varied) {
            return usual;
        }
        Random random = new Random(seed);
        return new StartPlace(
                usual.number(),
                usual.x() - VARIED_METRES * random.nextDouble(),
                usual.y() + VARIED_METRES * (2 * random.nextDouble() - 1),
                usual.degrees() + VARIED_DEGREES * (2 * random.nextDouble() - 1));
    }

    long seedOf(String team) {
        return ownSeeds.getOrDefault(team, seed);
    }

    /** A seed for one of several trials of the same teams. */
    long seedOf(int... numbers) {
        long mixed = seed;
        for (int number : numbers) {
            mixed = new Random(mixed * 31 + number).nextLong();
        }
        return mixed;
    }
}
