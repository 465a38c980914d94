package org.robonewbie.learning.gym;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.robonewbie.learning.experiment.ObservedQuantity;
import org.robonewbie.learning.experiment.SoccerTrial;
import org.robonewbie.learning.experiment.TrialSetting;
import org.robonewbie.nao.BodyPart;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.SimSparkFrame;
import org.robonewbie.simulator.physics.BodyPose;

/**
 * Bring the left lower arm to a random point in front of and beside the left shoulder. Each cycle costs the distance in metres.
 */
final class ReachTask implements Task {

    private static final List<Joint> ARM =
            List.of(Joint.LEFT_SHOULDER_PITCH, Joint.LEFT_SHOULDER_YAW, Joint.LEFT_ARM_ROLL, Joint.LEFT_ARM_YAW);
    private static final Vector3 SHOULDER = new Vector3(0, 0.098, 0.075);
    private static final double REACH_METRES = 0.15;

    @Override
    public String name() {
        return "Reach";
    }

    @Override
    public TrialSetting setting() {
        return TrialSetting.standing().withoutCamera();
    }

    @Override
    public List<Joint> joints() {
        return ARM;
    }

    @Override
    public double rangeDegrees() {
        return 120;
    }

    @Override
    public int longestCycles() {
        return 100;
    }

    @Override
    public List<ObservedQuantity> extras() {
        List<ObservedQuantity> all = new ArrayList<>();
        for (String thing : List.of("target", "arm")) {
            for (String axis : List.of("forward", "left", "up")) {
                all.add(new ObservedQuantity(thing + "." + axis, "m", -0.5, 0.5));
            }
        }
        return all;
    }

    @Override
    public Episode begin(SoccerTrial trial, SplittableRandom random) {
        double side = Math.PI * (random.nextDouble() - 0.25) / 2;
        double height = Math.PI * (random.nextDouble() - 0.5) / 1.5;
        Vector3 target = SHOULDER.plus(
                new Vector3(Math.cos(side) * Math.cos(height), Math.sin(side) * Math.cos(height), Math.sin(height))
                        .times(REACH_METRES));
        return new Episode() {

            @Override
            public double reward(double[] action) {
                return -arm().distanceTo(target);
            }

            @Override
            public boolean isOver() {
                return trial.state().robot().isFallen();
            }

            @Override
            public double[] extras() {
                Vector3 arm = arm();
                return new double[] {target.x(), target.y(), target.z(), arm.x(), arm.y(), arm.z()};
            }

            private Vector3 arm() {
                BodyPose torso = trial.state().robot().torso();
                return SimSparkFrame.toBody(torso.toLocal(trial.state().robot().position(BodyPart.LEFT_LOWER_ARM)));
            }
        };
    }
}
