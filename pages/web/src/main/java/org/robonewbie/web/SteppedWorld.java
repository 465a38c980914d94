package org.robonewbie.web;

import java.util.List;
import java.util.function.IntPredicate;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.AgentMessages;
import org.robonewbie.simulator.WorldSnapshot;

/** What a page watches: a world with its robots, which goes on cycle by cycle. */
interface SteppedWorld {

    /** Goes on for one cycle of 20 ms, in which all robots have their turn. */
    void cycle();

    /** {@return whether it does not go on any more} */
    boolean isOver();

    /** {@return how many cycles it has gone on} */
    long cycles();

    /**
     * Looks at the world.
     *
     * @param paused whether it is paused
     * @param speed simulated seconds per second
     * @return its present state
     */
    WorldSnapshot snapshot(boolean paused, double speed);

    /**
     * Carries out an order of a person.
     *
     * @param order the order
     */
    void order(Order order);

    /**
     * Listens to what agents and simulator have told each other in the last cycle.
     *
     * @param robots whose messages are wanted
     * @return the messages
     */
    List<AgentMessages> messages(IntPredicate robots);
}
