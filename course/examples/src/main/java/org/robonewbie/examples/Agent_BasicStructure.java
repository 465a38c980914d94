package org.robonewbie.examples;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.Options;
import org.robonewbie.nao.Joint;

/**
 * Lesson 2: the basic structure of an agent, which raises its left arm to 30 degrees.
 *
 * <p>The framework turns the cycle: it senses (reads all sensors), calls {@link #think}, and acts (sends all commands), 50 times
 * per simulated second. {@code think} decides by the sensors what the motors do.
 *
 * <p>The arm stops a little above 30 degrees. Why? A command shows its effect in the message after the next: when the sensor
 * first says 30, two more steps are already under way. Try other speeds: by how much does the arm go too far? With
 * {@code nao.setJointAngle(Joint.LEFT_SHOULDER_PITCH, 30)} the framework takes care of that.
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
        if (angle != angleBefore) { // until the arm rests
            log.info("left shoulder pitch %.2f degrees", angle);
        }
        angleBefore = angle;
    }
}
