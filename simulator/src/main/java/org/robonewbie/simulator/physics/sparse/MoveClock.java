package org.robonewbie.simulator.physics.sparse;

/** Counts the moves of forms, so that ODE can be told of them later in the order in which they happened. */
final class MoveClock {

    private int period;
    private int turn;

    /** A period lasts from one search for contacts to the next. */
    int period() {
        return period;
    }

    void beginPeriod() {
        period++;
    }

    int nextTurn() {
        return turn++;
    }
}
