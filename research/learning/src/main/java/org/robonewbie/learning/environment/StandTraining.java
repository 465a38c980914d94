package org.robonewbie.learning.environment;

import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.trial.WorldState;

/**
 * Stay upright while pushes come from any side once per second, each time harder. Reward per cycle: 1 less the lean of the
 * torso (1 for 60°).
 */
final class StandTraining extends TrainingTask {

    private static final double STEP_NEWTONS = 8;
    private static final double BORNE_SECONDS = 6;

    private double totalReward;
    private int cyclesOnItsFeet;

    @Override
    public double pushNewtons() {
        return STEP_NEWTONS;
    }

    @Override
    public double rangeDegrees() {
        return 30;
    }

    @Override
    protected void see(WorldState first, WorldState now) {
        if (!hasFallen()) {
            cyclesOnItsFeet++;
        }
        totalReward += 1 - now.robot().tiltDegrees() / BodyState.FALLEN_DEGREES;
    }

    /** {@return whether the robot has stood for 6 s, in which it was pushed with up to 40 N} */
    @Override
    public boolean isDone() {
        return cyclesOnItsFeet * Cycle.SECONDS >= BORNE_SECONDS;
    }

    @Override
    public double value() {
        return totalReward;
    }
}
