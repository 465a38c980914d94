package org.robonewbie.learning.series;

import org.robonewbie.nao.Joint;
import org.robonewbie.trial.*;
import org.robonewbie.trial.measure.*;

/** The example of docs/experiments.md: how long does a robot stand that bends a hip? */
public class FirstExperiment {
    public static void main(String[] arguments) {
        Scene scene = Scene.of(RobotStart.at(1.5, 0).after("stand"));
        for (long seed = 1; seed <= 5; seed++) {
            double hip = 20 * seed;
            Controller bending = Controller.ofPolicy(readings -> {
                double[] speeds = new double[Joint.COUNT];
                double arm = readings.degrees(Joint.LEFT_SHOULDER_PITCH);
                speeds[Joint.LEFT_SHOULDER_PITCH.ordinal()] = arm < 30 ? 60 : 0;
                speeds[Joint.LEFT_HIP_PITCH.ordinal()] = hip;
                return speeds;
            });
            try (Trial trial = Trial.direct(scene, seed, bending)) {
                Measure standing = new Standing();
                Measure lean = new Upright();
                trial.run(3, standing, lean);
                System.out.printf(
                        "%.0f degrees per second: %.2f s on its feet, mean tilt %.1f degrees%n",
                        hip, standing.value(), lean.value());
            }
        }
    }
}
