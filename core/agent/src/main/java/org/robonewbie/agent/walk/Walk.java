package org.robonewbie.agent.walk;

/**
 * An omnidirectional walk, faster and more agile than keyframe motions: forward, sideways and turning at the same time.
 *
 * <pre>{@code
 * walk.towards(0.4, 0, ballBearing);    // turns to the ball while walking
 * if (ballDistance < 0.2) {
 *     motions.start("kick-right");      // the robot first stops walking, then kicks
 * }
 * }</pre>
 *
 * <p>A velocity stays in effect until another one is set, {@link #stop} is called or a motion is started; the robot
 * does not walk while a motion is running. The velocity changes only between steps, and a step cannot be interrupted,
 * so a reaction takes about half a second. A robot that is lying on the ground does not walk; {@code
 * motions.startGetUp()} makes it get up.
 *
 * <p>The postures are computed by {@link WalkEngine}, whose documentation explains the method.
 */
public interface Walk {

    /** Maximum forward speed in metres per second; the maximum backward speed is lower. */
    double MAX_FORWARD = WalkStyle.STANDARD.most().forward();

    /** Maximum sideways speed in metres per second. */
    double MAX_LEFT = WalkStyle.STANDARD.most().left();

    /** Maximum turn rate in degrees per second. */
    double MAX_TURN = WalkStyle.STANDARD.most().turn();

    /**
     * Sets the walking velocity. Velocities beyond the limits are scaled down; the direction is preserved.
     *
     * @param forwardMetresPerSecond up to {@link #MAX_FORWARD}; negative is backward
     * @param leftMetresPerSecond up to {@link #MAX_LEFT}; negative is to the right
     * @param turnDegreesPerSecond up to {@link #MAX_TURN}; positive is to the left, negative to the right
     */
    void towards(double forwardMetresPerSecond, double leftMetresPerSecond, double turnDegreesPerSecond);

    /** Stops with the feet side by side, within a second. */
    void stop();

    /**
     * Sets the parameters of the walk, such as the height of the feet, the step duration and the balance gains. They take
     * effect with the next step; a robot that walks faster than they allow slows down first.
     *
     * <pre>{@code
     * double[] x = WalkStyle.coordinates();
     * x[WalkParameter.LEAN.ordinal()] += 0.5;
     * walk.setStyle(WalkStyle.of(180, new WalkVelocity(1.1, 1.2, 1.2), new WalkVelocity(0.7, 0.2, 60), x));
     * }</pre>
     *
     * @param style the parameters; initially {@link WalkStyle#STANDARD}
     */
    void setStyle(WalkStyle style);

    /**
     * Sets a learned walk, which takes effect like a style; {@link #setStyle} replaces it.
     *
     * <pre>{@code
     * walk.setPolicy(new PolicyWalk(PolicyFile.shipped("walk")));
     * walk.towards(0.8, 0, 0);
     * }</pre>
     *
     * @param policy the learned walk
     */
    default void setPolicy(PolicyWalk policy) {
        setStyle(policy.style()); // custom walks may not support reflexes
    }

    /** {@return whether the robot is walking, including the steps until it has stopped} */
    boolean isWalking();
}
