package org.robonewbie.simulator.soccer;

/** Actions of the referee in one play mode. */
interface PlayModeRule extends Memory {

    /** Called when the play mode starts. */
    default void begin() {}

    /** Called in each cycle; can change the play mode. */
    void apply();
}
