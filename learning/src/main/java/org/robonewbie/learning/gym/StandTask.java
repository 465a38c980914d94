package org.robonewbie.learning.gym;

import java.util.List;
import java.util.SplittableRandom;
import org.robonewbie.learning.experiment.SoccerTrial;
import org.robonewbie.learning.experiment.TrialSetting;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyState;

/**
 * Stay on your feet while someone pushes you from any side once per second. Each cycle pays 1, less what the torso leans (1
 * for 60°).
 */
final class StandTask implements Task {

    private static final int CYCLES_BETWEEN_PUSHES = 50;
    private static final int CYCLES_OF_A_PUSH = 5;
    private static final double WEAKEST_NEWTONS = 20;
    private static final double MORE_NEWTONS = 40;

    @Override
    public String name() {
        return "Stand";
    }

    @Override
    public TrialSetting setting() {
        return TrialSetting.standing().withoutCamera();
    }

    @Override
    public List<Joint> joints() {
        return LegJoints.ALL;
    }

    @Override
    public double rangeDegrees() {
        return 30;
    }

    @Override
    public int longestCycles() {
        return 500;
    }

    @Override
    public Episode begin(SoccerTrial trial, SplittableRandom random) {
        return new Episode() {

            private Vector3 push = Vector3.ZERO;
            private int cycle;

            @Override
            public void beforeStep() {
                int phase = cycle++ % CYCLES_BETWEEN_PUSHES;
                if (phase == CYCLES_BETWEEN_PUSHES - CYCLES_OF_A_PUSH) {
                    double side = 2 * Math.PI * random.nextDouble();
                    double newtons = WEAKEST_NEWTONS + MORE_NEWTONS * random.nextDouble();
                    push = new Vector3(newtons * Math.cos(side), newtons * Math.sin(side), 0);
                }
                if (phase >= CYCLES_BETWEEN_PUSHES - CYCLES_OF_A_PUSH) {
                    trial.world().robots().get(0).push(push);
                }
            }

            @Override
            public double reward(double[] action) {
                return 1 - trial.state().robot().tiltDegrees() / BodyState.FALLEN_DEGREES;
            }

            @Override
            public boolean isOver() {
                return trial.state().robot().isFallen();
            }
        };
    }
}
