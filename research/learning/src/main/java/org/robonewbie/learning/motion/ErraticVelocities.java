package org.robonewbie.learning.motion;

import java.util.Random;
import java.util.function.Supplier;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.agent.walk.WalkVelocity;

/** Random velocity commands that change every 0.7 s on average and often exceed the limits of the walk. */
public final class ErraticVelocities implements Supplier<WalkVelocity> {

    private final WalkVelocity max;
    private final Random random;
    private WalkVelocity current = WalkVelocity.ZERO;

    /**
     * Creates a sequence of commands that begins with standing.
     *
     * @param style the walk whose speed limits scale the velocities
     * @param seed the seed of the velocities
     */
    public ErraticVelocities(WalkStyle style, long seed) {
        max = style.most();
        random = new Random(17 * seed + 1);
        random.nextLong();
    }

    @Override
    public WalkVelocity get() {
        current = random.nextDouble() < 0.03 ? next() : current;
        return current;
    }

    private WalkVelocity next() {
        if (random.nextDouble() < 0.15) {
            return WalkVelocity.ZERO;
        }
        double sharpness = random.nextDouble();
        return new WalkVelocity(
                max.forward() * share(sharpness), max.left() * share(sharpness), max.turn() * share(sharpness));
    }

    private double share(double sharpness) {
        return random.nextDouble() < 0.3 ? 0 : (0.5 + sharpness) * random.nextGaussian();
    }
}
