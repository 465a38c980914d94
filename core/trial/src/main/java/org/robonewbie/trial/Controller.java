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
 * Controls a robot in a {@link Trial}. The source of its commands may be an in-process agent, a program in another process, a
 * motion, a walk, a policy or constant joint speeds.
 *
 * <p>A controller responds to the sensor readings of each cycle with commands. It is stateful, so each robot of each trial
 * needs its own instance.
 */
@FunctionalInterface
public interface Controller extends AutoCloseable {

    /**
     * Returns a controller for an in-process agent.
     *
     * @param agent the agent; its {@code main} and {@code defaults} have no effect
     * @return the controller
     */
    static Controller ofAgent(Agent agent) {
        return new AgentController(agent);
    }

    /**
     * Returns a controller that plays a motion once and then holds all joints still.
     *
     * @param motion the motion
     * @return the controller
     */
    static Controller ofMotion(Motion motion) {
        return new MotionController(new MotionPlayer(motion, Interpolation.LINEAR));
    }

    /**
     * Returns a controller that plays the motion in a file once, with the interpolation specified there, and then holds all
     * joints still.
     *
     * @param file the file; see {@link MotionPlayer#of}
     * @return the controller
     * @throws org.robonewbie.nao.motion.MotionFormatException if the file cannot be parsed
     */
    static Controller ofMotion(MotionFile file) {
        return new MotionController(MotionPlayer.of(file, 1, Interpolation.LINEAR));
    }

    /**
     * Returns a controller that walks at a constant velocity; see {@link org.robonewbie.agent.walk.Walk#towards}.
     *
     * @param forwardMetresPerSecond forward speed
     * @param leftMetresPerSecond sideways speed, positive to the left
     * @param turnDegreesPerSecond turn rate, positive to the left
     * @return the controller
     */
    static Controller ofWalk(double forwardMetresPerSecond, double leftMetresPerSecond, double turnDegreesPerSecond) {
        return ofAgent(new WalkingAgent(forwardMetresPerSecond, leftMetresPerSecond, turnDegreesPerSecond));
    }

    /**
     * Returns a controller that computes joint speeds from joint angles, gyroscope and accelerometer. For a policy that
     * needs more inputs, implement this interface directly.
     *
     * @param policy computes the speed of each joint in degrees per second, in the order of {@link org.robonewbie.nao.Joint}
     * @return the controller
     */
    static Controller ofPolicy(Function<SensorReadings, double[]> policy) {
        return new PolicyController(policy);
    }

    /**
     * Returns a controller with constant joint speeds.
     *
     * @param degreesPerSecond the speed of each joint in the order of {@link org.robonewbie.nao.Joint}; omit them to hold still
     * @return the controller
     */
    static Controller ofSpeeds(double... degreesPerSecond) {
        double[] copy = JointSpeeds.checked(degreesPerSecond);
        return ofPolicy(readings -> copy);
    }

    /**
     * Sets the type of the controlled robot. Called before any other method.
     *
     * @param type the robot type
     */
    default void embody(RobotType type) {}

    /**
     * Sets the robot's identity. Called before the first readings are passed.
     *
     * @param team name of the robot's team
     * @param number uniform number
     * @param side the side of the robot's team
     */
    default void introduce(String team, int number, TeamSide side) {}

    /**
     * Passes readings to the controller before the trial starts, so that programs in other processes can join the game.
     * Commands that they send are ignored.
     *
     * @param readings the sensor readings
     */
    default void awake(SensorReadings readings) {}

    /**
     * Computes the commands for the readings of one cycle.
     *
     * @param readings the sensor readings
     * @return the commands
     */
    List<EffectorCommand> respond(SensorReadings readings);

    /** {@return whether the controller needs complete messages with camera images; a direct trial is faster without them} */
    default boolean readsMessages() {
        return true;
    }

    /** {@return whether the controller has finished; always false for a controller without a defined end} */
    default boolean isFinished() {
        return false;
    }

    /** Releases the controller's resources. */
    @Override
    default void close() {}
}
