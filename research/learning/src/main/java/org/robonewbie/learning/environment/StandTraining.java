package org.robonewbie.learning.environment;

import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.trial.WorldState;

/**
 * Task: keep balance while being pushed from random sides once per second, each time harder than before.
 */
final class StandTraining extends TrainingTask {

    private static final double STEP_NEWTONS = 8;
    private static final double GOAL_SECONDS = 6;

    private double totalReward;
    private int standingCycles;

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
            standingCycles++;
        }
        totalReward += 1 - now.robot().tiltDegrees() / BodyState.FALLEN_DEGREES;
    }

    /** {@return whether the robot has remained standing for 6 s, despite pushes of up to 40 N} */
    @Override
    public boolean isDone() {
        return standingCycles * Cycle.SECONDS >= GOAL_SECONDS;
    }

    @Override
    public String rewardRule() {
        return "1 per cycle, minus the tilt of the torso (1 for 60 degrees). A push every second, each 8 N " + "harder";
    }

    @Override
    public String successRule() {
        return "stands for 6 s, pushed with up to 40 N";
    }

    @Override
    public double value() {
        return totalReward;
    }
}
