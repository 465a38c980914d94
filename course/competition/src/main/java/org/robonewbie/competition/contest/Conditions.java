package org.robonewbie.competition.contest;

import java.util.Map;
import java.util.Random;

/**
 * Seeds and variations of a contest.
 *
 * @param seed seed of all random numbers
 * @param varied whether start poses depend on the seed, so that teams cannot prepare for them
 * @param ownSeeds seeds by team name, for teams that play with a different seed in experiments
 */
public record Conditions(long seed, boolean varied, Map<String, Long> ownSeeds) {

    private static final double VARIED_METRES = 0.3;
    private static final double VARIED_DEGREES = 20;

    /** Creates the conditions. */
    public Conditions {
        ownSeeds = Map.copyOf(ownSeeds);
    }

    /**
     * Returns the default conditions.
     *
     * @param seed seed of all random numbers
     * @return conditions with the same seed for all teams and with fixed start poses
     */
    public static Conditions of(long seed) {
        return new Conditions(seed, false, Map.of());
    }

    /** Returns the start pose, which may vary with the seed but is the same for all teams. */
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

    /** Derives the seed of a trial from the numbers that identify it. */
    long seedOf(int... numbers) {
        long mixed = seed;
        for (int number : numbers) {
            mixed = new Random(mixed * 31 + number).nextLong();
        }
        return mixed;
    }
}
