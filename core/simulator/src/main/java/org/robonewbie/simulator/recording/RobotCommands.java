package org.robonewbie.simulator.recording;

import java.util.List;

/**
 * The commands of an agent in one cycle.
 *
 * @param id id of the agent's robot
 * @param hingeSpeeds the hinge speeds that have changed
 * @param others all other commands as text
 */
public record RobotCommands(int id, List<HingeSpeed> hingeSpeeds, List<String> others) {

    /** Makes the lists unmodifiable. */
    public RobotCommands {
        hingeSpeeds = List.copyOf(hingeSpeeds);
        others = List.copyOf(others);
    }

    /**
     * A new speed of a motor.
     *
     * @param hinge index of the hinge in {@code NaoModel.of(type).hinges()}
     * @param radiansPerSecond the commanded speed
     */
    public record HingeSpeed(int hinge, double radiansPerSecond) {}
}
