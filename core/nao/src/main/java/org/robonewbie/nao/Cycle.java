package org.robonewbie.nao;

/** The beat of the simulated world: sense, think and act happen once per cycle, 50 times per simulated second. */
public final class Cycle {

    /** Length of a cycle in simulated seconds. */
    public static final double SECONDS = 0.02;

    private Cycle() {}
}
