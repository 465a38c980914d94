package org.robonewbie.trial;

import java.util.List;
import org.robonewbie.simulator.cycle.SteppedSimulator;

/** A world with the complete simulation cycle, including a referee and messages in both directions. */
final class ServedWorld implements World {

    private final SteppedSimulator simulator;

    ServedWorld(SteppedSimulator simulator) {
        this.simulator = simulator;
    }

    @Override
    public void cycle(List<TrialBody> bodies) {
        bodies.forEach(TrialBody::send);
        simulator.cycle();
        bodies.forEach(TrialBody::receive);
    }

    @Override
    public void keep() {
        // A served trial cannot be reset.
    }

    @Override
    public void setPhysics(ExternalPhysics physics) {
        throw new IllegalStateException("A served trial has its own physics. Use a direct trial.");
    }

    @Override
    public void reset(long seed) {
        throw new IllegalStateException("A served trial cannot be reset. Create a new one, or use a direct trial.");
    }
}
