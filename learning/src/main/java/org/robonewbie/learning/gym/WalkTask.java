package org.robonewbie.learning.gym;

import java.util.List;
import java.util.SplittableRandom;
import org.robonewbie.learning.experiment.SoccerTrial;
import org.robonewbie.learning.experiment.TrialSetting;
import org.robonewbie.nao.Joint;

/** Walk ahead. Each metre along the first heading pays 10, each cycle on the feet 0.02. */
final class WalkTask implements Task {

    private static final double FOR_A_METRE = 10;
    private static final double FOR_A_CYCLE = 0.02;

    @Override
    public String name() {
        return "Walk";
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
        return 40;
    }

    @Override
    public int longestCycles() {
        return 500;
    }

    @Override
    public Episode begin(SoccerTrial trial, SplittableRandom random) {
        return new Episode() {

            private double metres = trial.state().robot().position().x();

            @Override
            public double reward(double[] action) {
                double before = metres;
                metres = trial.state().robot().position().x();
                return FOR_A_METRE * (metres - before) + FOR_A_CYCLE;
            }

            @Override
            public boolean isOver() {
                return trial.state().robot().isFallen();
            }
        };
    }
}
