package org.robonewbie.simulator.soccer;

/** The referee's actions in one play mode. */
interface PlayModeRule extends Memory {

    /** Called when the play mode starts. */
    default void begin() {}

    /** Called in each cycle; can change the play mode. */
    void apply();
}
