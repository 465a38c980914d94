package org.robonewbie.learning.motion;

import java.util.Random;
import java.util.function.Supplier;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.agent.walk.WalkVelocity;

/** Random walk velocities: a new one every 0.7 s on average, often beyond what the walk can do. */
public final class ErraticVelocities implements Supplier<WalkVelocity> {

    private final WalkVelocity most;
    private final Random random;
    private WalkVelocity current = WalkVelocity.ZERO;

    /**
     * Begins with standing.
     *
     * @param style the walk, whose largest speeds scale the velocities
     * @param seed chooses the velocities
     */
    public ErraticVelocities(WalkStyle style, long seed) {
        most = style.most();
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
                most.forward() * share(sharpness), most.left() * share(sharpness), most.turn() * share(sharpness));
    }

    private double share(double sharpness) {
        return random.nextDouble() < 0.3 ? 0 : (0.5 + sharpness) * random.nextGaussian();
    }
}
