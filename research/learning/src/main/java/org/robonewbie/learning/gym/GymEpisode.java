package org.robonewbie.learning.gym;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import org.robonewbie.agent.policy.MotionGuide;
import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.JointStates;
import org.robonewbie.nao.motion.Motors;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.Measure;
import org.robonewbie.trial.SensorReadings;
import org.robonewbie.trial.WorldState;

/** One attempt at a task: the robot that does what a learning program wants, and what it earns by that. */
final class GymEpisode implements Controller {

    private static final List<Joint> ALL_JOINTS = List.of(Joint.values());

    private final GymTask task;
    private final Measure measure;
    private final Controller motor = Controller.ofPolicy(this::speeds);
    private final JointStates joints = new JointStates();
    private final Motors motors = new Motors(joints);
    private Posture firstPosture = Posture.ZERO;
    private Optional<MotionGuide> guide = Optional.empty();
    private Optional<WalkGuide> walk = Optional.empty();
    private int cycles;
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

    /** Takes the first posture, from which actions are counted. */
    void stand(WorldState state) {
        firstPosture = state.robots().get(task.robot()).joints();
        guide = task.motion().map(motion -> new MotionGuide(motion, firstPosture));
        walk = task.walk().map(policy -> new WalkGuide(new PolicyWalk(policy).style(), motors));
    }

    /** Begins when the scene is complete. */
    void begin(WorldState state, int delayCycles) {
        for (int i = 0; i < delayCycles; i++) {
            underWay.add(new double[task.joints().size()]);
        }
        see(state);
        reward = 0;
    }

    /** Chooses what the robot does in the next cycle. Numbers beyond 1 count as 1. */
    void act(double... newAction) {
        underWay.add(newAction);
        action = underWay.remove();
    }

    /** Begins to count what an action earns. */
    void beginReward() {
        reward = 0;
    }

    /** Looks at what came of a cycle. */
    void see(WorldState state) {
        double before = value;
        task.see(state);
        if (measure != task) {
            measure.see(state);
        }
        value = measure.isLargerBetter() ? measure.value() : -measure.value();
        reward += value - before;
    }

    /** Takes in what the robot perceives. */
    void feel(double... perceived) {
        walk.ifPresent(one -> one.plan(task.velocity(), perceived));
    }

    /** The reward of the last action. */
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

    /** How far the task's motion has got, or what is observed of its walk; nothing if it has neither. */
    double[] progress() {
        return walk.isPresent() ? walk.get().inputs() : motionProgress();
    }

    private double[] motionProgress() {
        return guide.map(one -> one.progress(cycles)).orElse(new double[0]);
    }

    private double[] speeds(SensorReadings readings) {
        readings.sense(joints);
        if (walk.isPresent() && action.length > 0) {
            walk.get().move(limited(action));
        } else if (action.length > 0) {
            move();
        }
        motors.endCycle();
        return motors.sentDegreesPerSecond();
    }

    private static double[] limited(double... action) {
        return Arrays.stream(action)
                .map(part -> Math.max(-1, Math.min(1, part)))
                .toArray();
    }

    private void move() {
        cycles++;
        double[] parts = limited(action);
        double[] degrees =
                guide.map(one -> one.posture(cycles)).orElse(firstPosture).toArray();
        for (int i = 0; i < action.length; i++) {
            degrees[task.joints().get(i).ordinal()] += parts[i] * task.rangeDegrees();
        }
        for (Joint joint : guide.isPresent() ? ALL_JOINTS : task.joints()) {
            motors.setTarget(joint, joint.clampDegrees(degrees[joint.ordinal()]), joint.maxDegreesPerSecond());
        }
    }

    @Override
    public boolean readsMessages() {
        return task.hasCamera();
    }
}
