package org.robonewbie.simulator.physics.sparse;

import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;

/** Numbers the moves of shapes, so that deferred updates reach ODE's collision space in the original order. */
final class UpdateSequence implements Restorable {

    private int period;
    private int moveNumber;

    /** Returns the number of the current period, which lasts from one contact search to the next. */
    int period() {
        return period;
    }

    void beginPeriod() {
        period++;
    }

    int nextMoveNumber() {
        return moveNumber++;
    }

    @Override
    public void save(StateWriter out) {
        out.putInt(period);
        out.putInt(moveNumber);
    }

    @Override
    public void restore(StateReader in) {
        period = in.getInt();
        moveNumber = in.getInt();
    }
}
