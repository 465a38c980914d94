package org.robonewbie.trial;

import java.util.List;
import java.util.function.Function;
import org.robonewbie.agent.Agent;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Interpolation;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.MotionPlayer;
import org.robonewbie.protocol.effector.EffectorCommand;

/**
 * What moves a robot in a {@link Trial}: an agent of this process, a program of another process,
 * a motion, a walk, a policy or bare joint speeds.
 *
 * <p>A controller answers each cycle's sensor readings with commands. It keeps its own state, so each robot of each trial needs
 * its own controller.
 */
@FunctionalInterface
public interface Controller extends AutoCloseable {

    /**
     * Returns a controller for an agent of this process.
     *
     * @param agent the agent; its {@code main} and {@code defaults} have no effect
     * @return the controller
     */
    static Controller ofAgent(Agent agent) {
        return new AgentController(agent);
    }

    /**
     * Plays a motion once and then holds the joints.
     *
     * @param motion the motion
     * @return the controller
     */
    static Controller ofMotion(Motion motion) {
        return new MotionController(new MotionPlayer(motion, Interpolation.LINEAR));
    }

    /**
     * Plays the motion of a file once, by the rule that the file names, and then holds the joints.
     *
     * @param file the file, see {@link MotionPlayer#of}
     * @return the controller
     * @throws org.robonewbie.nao.motion.MotionFormatException if the file cannot be understood
     */
    static Controller ofMotion(MotionFile file) {
        return new MotionController(MotionPlayer.of(file, 1, Interpolation.LINEAR));
    }

    /**
     * Walks with one velocity, see {@link org.robonewbie.agent.walk.Walk#towards}.
     *
     * @param forwardMetresPerSecond speed ahead
     * @param leftMetresPerSecond speed to the left
     * @param turnDegreesPerSecond turning speed to the left
     * @return the controller
     */
    static Controller ofWalk(double forwardMetresPerSecond, double leftMetresPerSecond, double turnDegreesPerSecond) {
        return ofAgent(new WalkingAgent(forwardMetresPerSecond, leftMetresPerSecond, turnDegreesPerSecond));
    }

    /**
     * Turns joints with speeds that depend on what the robot feels: joint angles, gyroscope and accelerometer. A policy that
     * needs more implements this interface.
     *
     * @param policy calculates the speed of each joint in degrees per second, in the order of {@link
     *     org.robonewbie.nao.Joint}
     * @return the controller
     */
    static Controller ofPolicy(Function<SensorReadings, double[]> policy) {
        return new PolicyController(policy);
    }

    /**
     * Turns joints with constant speeds.
     *
     * @param degreesPerSecond the speed of each joint in the order of {@link org.robonewbie.nao.Joint}; none for a robot that
     *     holds still
     * @return the controller
     */
    static Controller ofSpeeds(double... degreesPerSecond) {
        double[] copy = JointSpeeds.checked(degreesPerSecond);
        return ofPolicy(readings -> copy);
    }

    /**
     * Sets the build of the robot that it moves, before anything else.
     *
     * @param type the robot type
     */
    default void embody(RobotType type) {}

    /**
     * Sets the controller's identity, before anything that it senses.
     *
     * @param team its team
     * @param number its number
     * @param side the half of its team
     */
    default void introduce(String team, int number, TeamSide side) {}

    /**
     * Passes on what the robot senses before the trial begins, so that programs of other processes can join the game. Their
     * answers are ignored.
     *
     * @param readings what the robot senses
     */
    default void awake(SensorReadings readings) {}

    /**
     * Answers the readings of one cycle.
     *
     * @param readings what the robot senses
     * @return what the robot does
     */
    List<EffectorCommand> respond(SensorReadings readings);

    /** {@return whether the controller reads whole messages with pictures; without them a direct trial is faster} */
    default boolean readsMessages() {
        return true;
    }

    /** {@return whether the controller has finished; one without an end never does} */
    default boolean isFinished() {
        return false;
    }

    /** Releases what the controller holds. */
    @Override
    default void close() {}
}
