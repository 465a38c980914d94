package org.robonewbie.agent.walk;

/**
 * Walks into any direction, faster and more nimbly than a motion of keyframes: forward, aside and turning at the same time.
 *
 * <pre>{@code
 * walk.towards(0.4, 0, ballBearing);    // turns to the ball while it walks
 * if (ballDistance < 0.2) {
 *     motions.start("kick-right");      // the robot first stops walking, then it kicks
 * }
 * }</pre>
 *
 * <p>A velocity holds until another one is given, {@link #stop} is called or a motion is started; while a motion is running the
 * robot does not walk. The robot changes its velocity from step to step, and no step can be broken off, so an answer takes
 * about half a second. A robot that lies on the ground does not walk: {@code motions.startGetUp()} brings it to its feet.
 *
 * <p>How it works: {@link WalkEngine}.
 */
public interface Walk {

    /** The largest speed forward in metres per second; backward it is less. */
    double MAX_FORWARD = WalkStyle.STANDARD.most().forward();

    /** The largest speed aside in metres per second. */
    double MAX_LEFT = WalkStyle.STANDARD.most().left();

    /** The largest speed of turning in degrees per second. */
    double MAX_TURN = WalkStyle.STANDARD.most().turn();

    /**
     * Sets the walking velocity. Values beyond the limits are scaled down; the direction is preserved.
     *
     * @param forwardMetresPerSecond up to {@link #MAX_FORWARD}; negative is backward
     * @param leftMetresPerSecond up to {@link #MAX_LEFT}; negative is to the right
     * @param turnDegreesPerSecond up to {@link #MAX_TURN}; positive is to the left, negative to the right
     */
    void towards(double forwardMetresPerSecond, double leftMetresPerSecond, double turnDegreesPerSecond);

    /** Stops with both feet side by side; that takes up to a second. */
    void stop();

    /**
     * Sets the numbers of the walk: how high the feet are lifted, how fast the steps follow each other, how the robot keeps its
     * balance. They hold from the next time on that the robot begins to walk.
     *
     * <pre>{@code
     * double[] x = WalkStyle.coordinates();
     * x[WalkParameter.LEAN.ordinal()] += 0.5;
     * walk.setStyle(WalkStyle.of(180, new WalkVelocity(1.1, 1.2, 1.2), new WalkVelocity(0.7, 0.2, 60), x));
     * }</pre>
     *
     * @param style the numbers; {@link WalkStyle#STANDARD} at first
     */
    void setStyle(WalkStyle style);

    /**
     * Walks as a robot has learned it, from the next time on that the robot begins to walk; {@link #setStyle} ends it.
     *
     * <pre>{@code
     * walk.setPolicy(new PolicyWalk(PolicyFile.shipped("walk")));
     * walk.towards(0.8, 0, 0);
     * }</pre>
     *
     * @param policy what was learned
     */
    default void setPolicy(PolicyWalk policy) {
        setStyle(policy.style()); // walks of your own may know no reflex
    }

    /** {@return whether the robot walks or has not yet come to a stand} */
    boolean isWalking();
}
