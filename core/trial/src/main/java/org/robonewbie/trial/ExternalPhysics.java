package org.robonewbie.trial;

import org.robonewbie.simulator.world.Ball;
import org.robonewbie.simulator.world.Robot;

/**
 * Physics engine that replaces the simulator's own in a direct trial with one robot.
 *
 * <pre>{@code
 * trial.setPhysics((robot, ball, speeds) -> robot.place(mujoco.step(robot, speeds)));
 * }</pre>
 */
@FunctionalInterface
public interface ExternalPhysics {

    /**
     * Advances robot and ball by one cycle of 20 ms: {@linkplain Robot#place places} them and {@linkplain Robot#setFootForces sets the foot
     * forces}.
     *
     * @param robot the robot, with the {@linkplain Robot#externalForce external forces} on its torso
     * @param ball the ball
     * @param radiansPerSecond target speed of the motor of each joint, in the order of the robot's model
     */
    void advance(Robot robot, Ball ball, double... radiansPerSecond);
}
