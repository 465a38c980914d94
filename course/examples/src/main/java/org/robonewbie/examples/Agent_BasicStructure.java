package org.robonewbie.examples;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.Options;
import org.robonewbie.nao.Joint;

/**
 * Lesson 2: the basic structure of an agent. This one raises its left arm to 30 degrees.
 *
 * <p>The framework runs the cycle 50 times per simulated second: it senses (reads all sensors), calls {@link #think}, and acts
 * (sends all commands). {@code think} computes motor commands from sensor readings.
 *
 * <p>The arm stops slightly above 30 degrees. Why? A command takes effect two messages later, so when the sensor first reads
 * 30, two more commands are already on their way. Try other speeds: by how much does the arm overshoot? {@code
 * nao.setJointAngle(Joint.LEFT_SHOULDER_PITCH, 30)} compensates for this.
 */
public final class Agent_BasicStructure extends Agent {

    private double angleBefore;

    /** Creates the agent. */
    public Agent_BasicStructure() {}

    /**
     * Starts the robot.
     *
     * @param args options such as {@code --headless}; {@code --help} lists them
     */
    public static void main(String[] args) {
        new Agent_BasicStructure().run(args);
    }

    @Override
    protected Options defaults() {
        return Options.none().withPose(-1, 0, 0);
    }

    @Override
    protected void think() {
        double angle = nao.getJointAngle(Joint.LEFT_SHOULDER_PITCH); // degrees
        nao.setJointSpeed(Joint.LEFT_SHOULDER_PITCH, angle < 30 ? 60 : 0); // degrees per second
        if (angle != angleBefore) { // until the arm is at rest
            log.info("left shoulder pitch %.2f degrees", angle);
        }
        angleBefore = angle;
    }
}
