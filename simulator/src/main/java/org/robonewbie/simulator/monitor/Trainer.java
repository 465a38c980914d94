package org.robonewbie.simulator.monitor;

import org.robonewbie.protocol.monitor.TrainerCommand;

/** Takes what monitors ask for to the simulation. Called on the monitor port's thread; nothing may wait. */
public interface Trainer {

    /**
     * Takes a command that shall be carried out between two cycles.
     *
     * @param command the command
     */
    void order(TrainerCommand command);

    /** Tells that a monitor has connected, so that a simulation whose clock stands still can show it the world. */
    void monitorArrived();
}
