package org.robonewbie.simulator.recording;

import java.util.List;

/**
 * What an agent commanded in one cycle.
 *
 * @param id number of the agent's connection
 * @param hingeSpeeds the hinge speeds that differ from those before
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
     * @param radiansPerSecond the speed as commanded
     */
    public record HingeSpeed(int hinge, double radiansPerSecond) {}
}
