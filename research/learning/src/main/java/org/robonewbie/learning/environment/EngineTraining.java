package org.robonewbie.learning.environment;

import java.util.Optional;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.walk.ResidualPolicy;
import org.robonewbie.agent.walk.WalkVelocity;

/** Correct the walk engine, which is asked for velocities at which it falls. */
abstract class EngineTraining extends CommandedTraining {

    private static final Policy ENGINE = WalkGuide.engine(140, new WalkVelocity(1.3, 0.2, 60), 0.3);

    @Override
    public Optional<Policy> walk() {
        return Optional.of(ENGINE);
    }

    @Override
    public final double rangeDegrees() {
        return ResidualPolicy.RANGE_DEGREES;
    }
}
