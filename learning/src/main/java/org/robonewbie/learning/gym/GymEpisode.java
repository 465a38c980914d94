package org.robonewbie.learning.gym;

import java.util.ArrayDeque;
import java.util.List;
import java.util.Queue;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.JointStates;
import org.robonewbie.nao.motion.Motors;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.trial.Measure;
import org.robonewbie.trial.Moment;
import org.robonewbie.trial.Performer;
import org.robonewbie.trial.Script;
import org.robonewbie.trial.SensorReadings;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.measure.Pushes;

/** One attempt at a task: the robot that does what a learning program wants, and what it earns by that. */
final class GymEpisode implements Performer {

    private static final int CYCLES_BETWEEN_PUSHES = 50;

    private final GymTask task;
    private final Measure measure;
    private final Performer motor = Performer.ofPolicy(this::speeds);
    private final JointStates joints = new JointStates();
    private final Motors motors = new Motors(joints);
    private Posture firstPosture = Posture.ZERO;
    private final Queue<double[]> underWay = new ArrayDeque<>();
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
    void begin(Trial trial, GymOptions.Drawn options, long seed) {
        firstPosture = trial.now().robot().joints();
        options.apply(trial);
        task.begin(trial);
        Script pushes = pushes(options.pushNewtons().orElse(task.pushNewtons()), seed);
        trial.with(world -> {
            pushes.act(world);
            task.act(world);
        });
        for (int i = 0; i < options.delayCycles(); i++) {
            underWay.add(new double[task.joints().size()]);
        }
        see(trial.now());
        reward = 0;
    }

    private static Script pushes(double newtons, long seed) {
        return newtons == 0 ? world -> {} : new Pushes(seed, CYCLES_BETWEEN_PUSHES, newtons);
    }

    /** Runs one cycle. Actions beyond 1 count as 1. */
    void step(Trial trial, double... newAction) {
        underWay.add(newAction);
        action = underWay.remove();
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
        readings.sense(joints);
        for (int i = 0; i < action.length; i++) {
            Joint joint = task.joints().get(i);
            double part = Math.max(-1, Math.min(1, action[i]));
            double target = firstPosture.degrees(joint) + part * task.rangeDegrees();
            motors.setTarget(joint, joint.clampDegrees(target), joint.maxDegreesPerSecond());
        }
        motors.endCycle();
        return motors.sentDegreesPerSecond();
    }

    @Override
    public boolean readsMessages() {
        return task.hasCamera();
    }
}
