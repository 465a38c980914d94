package org.robonewbie.learning.trial;

import java.util.Random;
import org.robonewbie.agent.walk.WalkEngine;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.motion.PostureFollower;

/**
 * A robot that walks with the walk engine from the stance, while it is pushed, and stops.
 *
 * @param stood whether it ended in the stance
 * @param seconds how long it was on its feet before the stop
 * @param planned how long it should have been
 * @param forward metres along its first heading
 * @param left metres to the left of its first heading
 * @param turnedDegrees degrees that it turned to the left
 * @param watch its stability
 */
public record WalkTrial(
        boolean stood, double seconds, double planned, double forward, double left, double turnedDegrees, Watch watch) {

    private static final double SECONDS_TO_STOP = 3;

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
        return run(style, new Course(seed, newtons), seconds, engine -> engine.towards(velocity));
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
        return run(style, new Course(seed, newtons), seconds, engine -> {
            if (random.nextDouble() < 0.03) {
                engine.towards(any(random, style));
            }
        });
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

    private static WalkTrial run(WalkStyle style, Course course, double seconds, Command command) {
        WalkEngine engine = new WalkEngine(style);
        PostureFollower follower = course.robot().follower();
        boolean up = true;
        while (up && course.watch().seconds() < seconds) {
            command.give(engine);
            up = course.walk(engine, follower);
        }
        double lasted = course.watch().seconds();
        double forward = course.forward();
        double left = course.left();
        double turned = course.turnedDegrees();
        engine.towards(WalkVelocity.ZERO);
        while (up && !engine.isStanding() && course.watch().seconds() < seconds + SECONDS_TO_STOP) {
            up = course.walk(engine, follower);
        }
        boolean stood = up && course.endsInStance();
        return new WalkTrial(stood, lasted, seconds, forward, left, turned, course.watch());
    }

    /** Commands the engine in each cycle. */
    private interface Command {
        void give(WalkEngine engine);
    }
}
