package org.robonewbie.learning.gym;

import java.util.List;
import java.util.SplittableRandom;
import org.robonewbie.learning.experiment.RobotStart;
import org.robonewbie.learning.experiment.SoccerTrial;
import org.robonewbie.learning.experiment.TrialSetting;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;

/** Kick the ball before the right foot ahead. Each metre that it comes nearer to the goal line pays 1, a fall costs 1. */
final class KickTask implements Task {

    @Override
    public String name() {
        return "Kick";
    }

    @Override
    public TrialSetting setting() {
        return TrialSetting.standing()
                .withRobots(List.of(RobotStart.at(-2, 0)))
                .withBall(new Vector3(-2 + 0.19, -0.055, 0.042))
                .withSpread(0.005, 0, 1);
    }

    @Override
    public List<Joint> joints() {
        return LegJoints.ALL;
    }

    @Override
    public double rangeDegrees() {
        return 60;
    }

    @Override
    public int longestCycles() {
        return 250;
    }

    @Override
    public Episode begin(SoccerTrial trial, SplittableRandom random) {
        return new Episode() {

            private double metres = trial.state().ballPosition().x();

            @Override
            public double reward(double[] action) {
                double before = metres;
                metres = trial.state().ballPosition().x();
                return metres - before - (isOver() ? 1 : 0);
            }

            @Override
            public boolean isOver() {
                return trial.state().robot().isFallen();
            }
        };
    }
}
