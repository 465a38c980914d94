package org.robonewbie.simulator.soccer;

/** One kind of foul. */
interface FoulRule extends Memory {

    /** Looks for fouls in this tick and tells the referee. */
    void judge();
}
