package org.robonewbie.exercises;

import java.util.List;
import org.robonewbie.agent.Agent;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.frame.MessageBuffer;

/** What moves a robot on a {@link Stage}: an agent of this process, or one of another process that has come through a {@link GuestDoor}. */
public interface Program extends AutoCloseable {

    /**
     * Takes an agent of this process.
     *
     * @param agent the agent
     * @return the program that asks it
     */
    static Program of(Agent agent) {
        return new AgentProgram(agent);
    }

    /**
     * Tells the program who it is, before anything else.
     *
     * @param team its team
     * @param number its number
     * @param side the half of its team
     */
    void introduce(String team, int number, TeamSide side);

    /**
     * Shows a message of the time before the trial, in which programs of other processes find into the game. What they do then
     * does not count.
     *
     * @param message what the robot senses
     */
    default void awake(MessageBuffer message) {}

    /**
     * Lets the program answer a message.
     *
     * @param message what the robot senses
     * @return what the robot does
     */
    List<EffectorCommand> respond(MessageBuffer message);

    /** Sends the program away. */
    @Override
    default void close() {}
}
