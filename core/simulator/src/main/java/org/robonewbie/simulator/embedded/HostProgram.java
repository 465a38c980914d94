package org.robonewbie.simulator.embedded;

/** The program that has started a simulator in its process. Thread-safe. */
public interface HostProgram {

    /** {@return the simple name of the program's class; empty if unknown} */
    String name();

    /** {@return the name of the robot with which the program plays, such as {@code NAO}} */
    String robot();

    /** {@return whether the program's robots are on the pitch} */
    boolean isRunning();

    /** Removes the program's robots from the pitch; the simulator continues to run. */
    void end();
}
