package org.robonewbie.web;

import java.util.List;
import java.util.function.IntPredicate;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.AgentMessages;
import org.robonewbie.simulator.WorldSnapshot;

/** A world, including its robots, that is advanced cycle by cycle. */
interface SteppedWorld {

    /** Advances by one cycle of 20 ms, in which each robot acts once. */
    void cycle();

    /** {@return whether the world has ended} */
    boolean isOver();

    /** {@return the number of cycles so far} */
    long cycles();

    /**
     * Returns the current state.
     *
     * @param paused whether it is paused
     * @param speed simulated seconds per second of real time
     * @return the current state
     */
    WorldSnapshot snapshot(boolean paused, double speed);

    /**
     * Executes a command from the user.
     *
     * @param order the command
     */
    void order(Order order);

    /**
     * Returns the messages exchanged between the agents and the simulator in the last cycle.
     *
     * @param robots selects the robots
     * @return the messages
     */
    List<AgentMessages> messages(IntPredicate robots);
}
