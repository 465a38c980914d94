package org.robonewbie.simulator.embedded;

/** The program that has started a simulator in its process. Thread-safe. */
public interface HostProgram {

    /** {@return the simple name of its class; empty if unknown} */
    String name();

    /** {@return whether its robots are on the pitch} */
    boolean isRunning();

    /** Removes its robots from the pitch. The simulator then runs until it ends or the process is terminated. */
    void end();
}
