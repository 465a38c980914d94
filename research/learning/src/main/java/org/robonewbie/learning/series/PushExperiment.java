package org.robonewbie.learning.series;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;

/**
 * Push recovery of a standing robot: in a trial of 2 s, a force acts on the torso from a random side for 0.1 s. The
 * parameter {@code newtons} sets the force.
 */
public final class PushExperiment implements Experiment {

    private static final String NEWTONS = "newtons";
    private static final Scene SCENE = Scene.of(RobotStart.at(1.5, 0).after("stand"));
    private static final double SECONDS = 2;
    private static final double SECONDS_OF_THE_PUSH = 5 * Cycle.SECONDS;
    private static final double DEFAULT_NEWTONS = 40;

    /** Creates the experiment. */
    public PushExperiment() {}

    @Override
    public List<String> columns() {
        return List.of("side_degrees", "fallen", "largest_tilt_degrees");
    }

    @Override
    public Optional<List<String>> parameters() {
        return Optional.of(List.of(NEWTONS));
    }

    @Override
    public double[] run(Map<String, Double> parameters, long seed) {
        double side = new RandomSource(seed).between(0, 360);
        Vector3 push = new Pose2d(0, 0, side).point(parameters.getOrDefault(NEWTONS, DEFAULT_NEWTONS), 0, 0);
        try (Trial trial = Trial.direct(SCENE, seed, Controller.ofSpeeds())) {
            double largestTilt = 0;
            while (trial.seconds() < SECONDS) {
                if (trial.seconds() < SECONDS_OF_THE_PUSH) {
                    trial.robot(0).push(push);
                }
                largestTilt = Math.max(largestTilt, trial.step().robot().tiltDegrees());
            }
            return new double[] {side, trial.now().robot().isFallen() ? 1 : 0, largestTilt};
        }
    }
}
