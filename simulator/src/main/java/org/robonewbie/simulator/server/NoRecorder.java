package org.robonewbie.simulator.server;

/** Records nothing. */
final class NoRecorder implements RunRecorder {

    @Override
    public void beforeStep() {}

    @Override
    public void afterStep() {}

    @Override
    public void cycleEnded(SimulationCycle cycle) {}
}
