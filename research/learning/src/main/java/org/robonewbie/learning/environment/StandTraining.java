package org.robonewbie.learning.environment;

import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.trial.WorldState;

/**
 * Stay on your feet while someone pushes you from any side once per second, each time harder. Each cycle pays 1, less what the
 * torso leans (1 for 60°).
 */
final class StandTraining extends TrainingTask {

    private static final double STEP_NEWTONS = 8;
    private static final double BORNE_SECONDS = 6;

    private double earned;
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
        earned += 1 - now.robot().tiltDegrees() / BodyState.FALLEN_DEGREES;
    }

    /** {@return whether the robot has stood for 6 s, in which it was pushed with up to 40 N} */
    @Override
    public boolean isDone() {
        return cyclesOnItsFeet * Cycle.SECONDS >= BORNE_SECONDS;
    }

    @Override
    public double value() {
        return earned;
    }
}
