package org.robonewbie.learning.series;

import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.robonewbie.learning.experiment.SoccerTrial;
import org.robonewbie.learning.experiment.TrialSetting;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;

/**
 * How hard can a standing robot be pushed? In a trial of two seconds someone pushes the torso for 0.1 s from a random side;
 * the parameter {@code newtons} tells how hard.
 */
public final class PushExperiment implements Experiment {

    private static final int CYCLES = 100;
    private static final int CYCLES_OF_THE_PUSH = 5;
    private static final double USUAL_NEWTONS = 40;

    /** Creates the experiment. */
    public PushExperiment() {}

    @Override
    public List<String> columns() {
        return List.of("side_degrees", "fallen", "largest_tilt_degrees");
    }

    @Override
    public double[] run(Map<String, Double> parameters, long seed) {
        SoccerTrial trial = new SoccerTrial(TrialSetting.standing().withoutCamera());
        trial.reset(seed);
        double side = 360 * new SplittableRandom(~seed).nextDouble();
        double newtons = parameters.getOrDefault("newtons", USUAL_NEWTONS);
        Vector3 push = new Vector3(Math.cos(Math.toRadians(side)), Math.sin(Math.toRadians(side)), 0).times(newtons);
        double largestTilt = 0;
        for (int i = 0; i < CYCLES; i++) {
            if (i < CYCLES_OF_THE_PUSH) {
                trial.world().robots().get(0).push(push);
            }
            trial.step(new double[Joint.COUNT]);
            largestTilt = Math.max(largestTilt, trial.state().robot().tiltDegrees());
        }
        return new double[] {side, trial.state().robot().isFallen() ? 1 : 0, largestTilt};
    }
}
