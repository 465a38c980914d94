package org.robonewbie.learning.experiment;

import org.robonewbie.nao.Joint;

/** The example of docs/experiments.md: how long does a robot stand that raises its arms? */
public class FirstExperiment {
    public static void main(String[] arguments) {
        Trial trial = new SoccerTrial(TrialSetting.standing());
        for (long seed = 1; seed <= 5; seed++) {
            trial.reset(seed);
            double reward = 0;
            while (trial.state().seconds() < 3 && !trial.state().robot().isFallen()) {
                double[] speeds = new double[Joint.COUNT];
                double arm = trial.observation(0)[Joint.LEFT_SHOULDER_PITCH.ordinal()];
                speeds[Joint.LEFT_SHOULDER_PITCH.ordinal()] = arm < 30 ? 60 : 0;
                speeds[Joint.LEFT_HIP_PITCH.ordinal()] = 5 * seed;
                trial.step(speeds);
                reward += 1 - trial.state().robot().tiltDegrees() / 90;
            }
            System.out.printf(
                    "seed %d: reward %.1f after %.2f s%n",
                    seed, reward, trial.state().seconds());
        }
    }
}
