package org.robonewbie.simulator.soccer;

/** Rule against one type of foul. */
interface FoulRule extends Memory {

    /** Detects fouls in this tick and reports them to the referee. */
    void judge();
}
