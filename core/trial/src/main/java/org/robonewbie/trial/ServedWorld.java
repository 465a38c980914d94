package org.robonewbie.trial;

import java.util.List;
import org.robonewbie.simulator.cycle.SteppedSimulator;

/** The whole cycle of the simulator, with messages in both directions and a referee. */
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
        // a served trial is not reset
    }

    @Override
    public void reset(long seed) {
        throw new IllegalStateException("Only a direct trial can be reset. Begin a new one.");
    }
}
