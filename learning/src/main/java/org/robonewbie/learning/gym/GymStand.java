package org.robonewbie.learning.gym;

import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.trial.Moment;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.measure.Pushes;

/**
 * Stay on your feet while someone pushes you from any side once per second, each time harder. Each cycle pays 1, less what the
 * torso leans (1 for 60°).
 */
final class GymStand extends GymTask {

    private static final int CYCLES_BETWEEN_PUSHES = 50;
    private static final double STEP_NEWTONS = 8;

    private Pushes pushes = pushes();
    private double earned;

    private Pushes pushes() {
        return new Pushes(chance().seed(), CYCLES_BETWEEN_PUSHES, STEP_NEWTONS);
    }

    @Override
    public void begin(Trial trial) {
        pushes = pushes();
    }

    @Override
    public void act(Trial trial) {
        pushes.act(trial);
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
