package org.robonewbie.learning.gym;

import java.util.List;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.JointStates;
import org.robonewbie.nao.motion.Motors;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.trial.Measure;
import org.robonewbie.trial.Moment;
import org.robonewbie.trial.Performer;
import org.robonewbie.trial.SensorReadings;
import org.robonewbie.trial.Trial;

/** One attempt at a task: the robot that does what a learning program wants, and what it earns by that. */
final class GymEpisode implements Performer {

    private static final Joint[] JOINTS = Joint.values();

    private final GymTask task;
    private final Measure measure;
    private final Performer motor = Performer.ofPolicy(this::speeds);
    private final JointStates joints = new JointStates();
    private final Motors motors = new Motors(joints);
    private Posture firstPosture = Posture.ZERO;
    private double[] action = {};
    private double value;
    private double reward;

    /** Rewards what the task itself pays. */
    GymEpisode(GymTask task) {
        this(task, task);
    }

    /** Rewards what a measure grows by, or shrinks by if less is better. */
    GymEpisode(GymTask task, Measure measure) {
        this.task = task;
        this.measure = measure;
    }

    GymTask task() {
        return task;
    }

    /** Completes the scene of a trial that is at its beginning. */
    void begin(Trial trial) {
        firstPosture = trial.now().robot().joints();
        task.begin(trial);
        trial.with(task);
        see(trial.now());
        reward = 0;
    }

    /** Runs one cycle. Actions beyond 1 count as 1. */
    void step(Trial trial, double... newAction) {
        action = newAction;
        see(trial.step());
    }

    private void see(Moment moment) {
        double before = value;
        task.see(moment);
        if (measure != task) {
            measure.see(moment);
        }
        value = measure.isLargerBetter() ? measure.value() : -measure.value();
        reward = value - before;
    }

    /** The reward of the last step. */
    double reward() {
        return reward;
    }

    /** Whether there is nothing more to earn. */
    boolean isOver() {
        return task.isDecided() || measure.isDecided();
    }

    @Override
    public List<EffectorCommand> respond(SensorReadings readings) {
        return motor.respond(readings);
    }

    private double[] speeds(SensorReadings readings) {
        for (Joint joint : JOINTS) {
            joints.sense(joint, readings.degrees(joint));
        }
        for (int i = 0; i < action.length; i++) {
            Joint joint = task.joints().get(i);
            double part = Math.max(-1, Math.min(1, action[i]));
            double target = firstPosture.degrees(joint) + part * task.rangeDegrees();
            motors.setTarget(joint, joint.clampDegrees(target), joint.maxDegreesPerSecond());
        }
        motors.endCycle();
        double[] speeds = new double[Joint.COUNT];
        for (Joint joint : JOINTS) {
            speeds[joint.ordinal()] = motors.sentDegreesPerSecond(joint);
        }
        return speeds;
    }

    @Override
    public boolean readsMessages() {
        return task.hasCamera();
    }
}
