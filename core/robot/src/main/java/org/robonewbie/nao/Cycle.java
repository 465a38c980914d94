package org.robonewbie.nao;

/** The control cycle: a robot senses, thinks and acts once per cycle, 50 times per simulated second. */
public final class Cycle {

    /** Length of a cycle in simulated seconds. */
    public static final double SECONDS = 0.02;

    private Cycle() {}
}
