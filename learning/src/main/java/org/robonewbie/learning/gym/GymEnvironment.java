package org.robonewbie.learning.gym;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.robonewbie.learning.experiment.ObservedQuantity;
import org.robonewbie.learning.experiment.SoccerTrial;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.JointStates;
import org.robonewbie.nao.motion.Motors;
import org.robonewbie.nao.motion.Posture;

/** One robot that lives through episodes of a task. */
final class GymEnvironment {

    /** Robots pass their stops by a little, and errors of sensors come on top. */
    private static final double ROOM = 0.1;

    private final Task task;
    private final SoccerTrial trial;
    private final List<ObservedQuantity> quantities;
    private final Posture firstPosture;
    private JointStates joints = new JointStates();
    private Motors motors = new Motors(joints);
    private Task.Episode episode;
    private double reward;

    GymEnvironment(Task task) {
        this.task = task;
        this.trial = new SoccerTrial(task.setting());
        this.quantities = quantities(task, trial);
        this.firstPosture = task.setting().robots().get(0).posture();
        this.episode = task.begin(trial, new SplittableRandom(0));
    }

    private static List<ObservedQuantity> quantities(Task task, SoccerTrial trial) {
        List<ObservedQuantity> all = new ArrayList<>(trial.quantities());
        all.addAll(task.extras());
        return all.stream().map(GymEnvironment::withRoom).toList();
    }

    private static ObservedQuantity withRoom(ObservedQuantity quantity) {
        double room = ROOM * (quantity.greatest() - quantity.least());
        return new ObservedQuantity(
                quantity.name(), quantity.unit(), quantity.least() - room, quantity.greatest() + room);
    }

    /** What is observed; values beyond the ranges are clamped. */
    List<ObservedQuantity> quantities() {
        return quantities;
    }

    Task task() {
        return task;
    }

    /** Begins an episode that is chosen by the seed. */
    void reset(long seed) {
        trial.reset(seed);
        joints = new JointStates();
        motors = new Motors(joints);
        episode = task.begin(trial, new SplittableRandom(~seed));
        reward = 0;
    }

    /** Runs one cycle. Actions beyond 1 count as 1. */
    void step(double[] action) {
        episode.beforeStep();
        trial.step(speeds(action));
        reward = episode.reward(action);
    }

    private double[] speeds(double[] action) {
        double[] felt = trial.observation(0);
        for (Joint joint : Joint.values()) {
            joints.sense(joint, felt[joint.ordinal()]);
        }
        for (int i = 0; i < action.length; i++) {
            Joint joint = task.joints().get(i);
            double part = Math.max(-1, Math.min(1, action[i]));
            double target = joint.clampDegrees(firstPosture.degrees(joint) + part * task.rangeDegrees());
            motors.setTarget(joint, target, joint.maxDegreesPerSecond());
        }
        motors.endCycle();
        double[] speeds = new double[Joint.COUNT];
        for (Joint joint : Joint.values()) {
            speeds[joint.ordinal()] = motors.sentDegreesPerSecond(joint);
        }
        return speeds;
    }

    /** The robot's present perception. */
    double[] observation() {
        double[] felt = trial.observation(0);
        double[] extras = episode.extras();
        double[] all = new double[felt.length + extras.length];
        System.arraycopy(felt, 0, all, 0, felt.length);
        System.arraycopy(extras, 0, all, felt.length, extras.length);
        for (int i = 0; i < all.length; i++) {
            all[i] = Math.max(
                    quantities.get(i).least(), Math.min(quantities.get(i).greatest(), all[i]));
        }
        return all;
    }

    /** The reward of the last step. */
    double reward() {
        return reward;
    }

    /** Whether the episode has ended. */
    boolean isOver() {
        return episode.isOver();
    }
}
