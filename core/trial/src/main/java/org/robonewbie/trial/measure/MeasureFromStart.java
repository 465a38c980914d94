package org.robonewbie.trial.measure;

import org.jspecify.annotations.Nullable;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.trial.Measure;
import org.robonewbie.trial.WorldState;

/** A measure of one robot of a trial, the first one, that compares with the beginning and knows when the robot has fallen. */
public abstract class MeasureFromStart implements Measure {

    private @Nullable WorldState start;
    private boolean fallen;

    /** Creates a measure that has not seen anything. */
    protected MeasureFromStart() {}

    @Override
    public final void see(WorldState state) {
        if (start == null) {
            start = state;
        }
        fallen |= watched(state).isFallen();
        see(start, state);
    }

    /**
     * Chooses the robot whose falls count.
     *
     * @param state what is true now
     * @return its body, that of the first robot unless a subclass says otherwise
     */
    protected BodyState watched(WorldState state) {
        return state.robot();
    }

    /**
     * Looks at the truth after a cycle.
     *
     * @param first the first moment that this measure has seen
     * @param now what is true now
     */
    protected abstract void see(WorldState first, WorldState now);

    /** {@return whether the robot has fallen since the first moment, even if it has got up again} */
    public final boolean hasFallen() {
        return fallen;
    }
}
