package org.robonewbie.learning.rehearsal;

import java.util.Random;
import java.util.function.Supplier;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.agent.walk.WalkVelocity;

/**
 * A robot that walks with the walk engine from the stance, while it is pushed, and stops.
 *
 * @param stood whether it ended in the stance
 * @param seconds how long it was on its feet before the stop
 * @param planned how long it should have been
 * @param forward metres along its first heading
 * @param left metres to the left of its first heading
 * @param turnedDegrees degrees that it turned to the left
 * @param poise how steady it was
 */
public record WalkTrial(
        boolean stood, double seconds, double planned, double forward, double left, double turnedDegrees, Poise poise) {

    /**
     * Walks with one velocity all the time.
     *
     * @param style the numbers of the walk
     * @param velocity where to walk
     * @param seconds how long
     * @param seed chooses the disturbances
     * @param newtons strength of the pushes
     * @return what happened
     */
    public static WalkTrial straight(
            WalkStyle style, WalkVelocity velocity, double seconds, long seed, double newtons) {
        return run(style, () -> velocity, seconds, seed, newtons);
    }

    /**
     * Walks with another velocity again and again, without any sense in it.
     *
     * @param style the numbers of the walk
     * @param seconds how long
     * @param seed chooses velocities and disturbances
     * @param newtons strength of the pushes
     * @return what happened
     */
    public static WalkTrial erratic(WalkStyle style, double seconds, long seed, double newtons) {
        Random random = new Random(17 * seed + 1);
        random.nextLong();
        WalkVelocity[] wanted = {WalkVelocity.ZERO};
        Supplier<WalkVelocity> fickle = () -> {
            wanted[0] = random.nextDouble() < 0.03 ? any(random, style) : wanted[0];
            return wanted[0];
        };
        return run(style, fickle, seconds, seed, newtons);
    }

    private static WalkVelocity any(Random random, WalkStyle style) {
        if (random.nextDouble() < 0.15) {
            return WalkVelocity.ZERO;
        }
        double sharpness = random.nextDouble();
        return new WalkVelocity(
                style.most().forward() * mostly(random, sharpness),
                style.most().left() * mostly(random, sharpness),
                style.most().turn() * mostly(random, sharpness));
    }

    private static double mostly(Random random, double sharpness) {
        return random.nextDouble() < 0.3 ? 0 : (0.5 + sharpness) * random.nextGaussian();
    }

    private static WalkTrial run(
            WalkStyle style, Supplier<WalkVelocity> velocity, double seconds, long seed, double newtons) {
        try (Rehearsal robot = Rehearsal.inStance(style, seed, newtons)) {
            robot.walk(velocity, () -> robot.seconds() < seconds);
            double lasted = robot.seconds();
            double forward = robot.forward();
            double left = robot.left();
            double turned = robot.turnedDegrees();
            boolean stood = robot.stopWalking() && robot.endsInStance();
            return new WalkTrial(stood, lasted, seconds, forward, left, turned, robot.poise());
        }
    }
}
