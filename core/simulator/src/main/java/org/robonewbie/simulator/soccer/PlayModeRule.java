package org.robonewbie.simulator.soccer;

/** What the referee does in one play mode. */
interface PlayModeRule extends Memory {

    /** Begins the play mode. */
    default void begin() {}

    /** Does what is due in each cycle, and may decide on another play mode. */
    void apply();
}
