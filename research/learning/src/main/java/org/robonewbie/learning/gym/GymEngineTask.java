package org.robonewbie.learning.gym;

import java.util.Optional;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.walk.ResidualPolicy;

/**
 * Correct the walk engine, which is told velocities at which it falls. It pays 1 per metre on the way that the robot was told to go,
 * and a fall costs 3.
 */
abstract class GymEngineTask extends GymCommandedTask {

    private static final double FOR_A_FALL = 3;
    private static final double GOAL_METRES = 5;

    /** How far the robot has got on its way. */
    abstract double metres();

    @Override
    public final Optional<Policy> walk() {
        return Optional.of(WalkGuide.ENGINE);
    }

    @Override
    public final double rangeDegrees() {
        return ResidualPolicy.RANGE_DEGREES;
    }

    /** {@return whether the robot has got 5 m ahead, as it was told, on its feet} */
    @Override
    public final boolean isDone() {
        return !hasFallen() && metres() >= GOAL_METRES;
    }

    @Override
    public final double value() {
        return metres() - (hasFallen() ? FOR_A_FALL : 0);
    }
}
