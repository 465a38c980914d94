package org.robonewbie.learning.gym;

import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.trial.Moment;

/**
 * Stay on your feet while someone pushes you from any side once per second, each time harder. Each cycle pays 1, less what the
 * torso leans (1 for 60°).
 */
final class GymStand extends GymTask {

    private static final double STEP_NEWTONS = 8;

    private double earned;

    @Override
    public double pushNewtons() {
        return STEP_NEWTONS;
    }

    @Override
    public double rangeDegrees() {
        return 30;
    }

    @Override
    protected void see(Moment first, Moment now) {
        earned += 1 - now.robot().tiltDegrees() / BodyState.FALLEN_DEGREES;
    }

    @Override
    public double value() {
        return earned;
    }
}
