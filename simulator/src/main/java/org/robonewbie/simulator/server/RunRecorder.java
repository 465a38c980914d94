package org.robonewbie.simulator.server;

/** Sees everything that belongs to a recording and to the report of a run. */
interface RunRecorder extends SimulationCycle.StepListener {

    /** A cycle is over and judged. */
    void cycleEnded(SimulationCycle cycle);
}
