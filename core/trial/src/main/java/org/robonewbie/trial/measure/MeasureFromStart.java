package org.robonewbie.trial.measure;

import org.jspecify.annotations.Nullable;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.trial.Measure;
import org.robonewbie.trial.WorldState;

/** Base class for measures of the first robot. Compares each state with the first observed state and detects falls. */
public abstract class MeasureFromStart implements Measure {

    private final String unit;
    private final boolean isLargerBetter;
    private @Nullable WorldState start;
    private boolean fallen;

    /** Creates a dimensionless measure for which larger values are better. */
    protected MeasureFromStart() {
        this("", true);
    }

    /**
     * Creates the measure.
     *
     * @param unit unit of the value
     * @param isLargerBetter whether larger values are better
     */
    protected MeasureFromStart(String unit, boolean isLargerBetter) {
        this.unit = unit;
        this.isLargerBetter = isLargerBetter;
    }

    @Override
    public String unit() {
        return unit;
    }

    @Override
    public boolean isLargerBetter() {
        return isLargerBetter;
    }

    @Override
    public final void see(WorldState state) {
        if (start == null) {
            start = state;
        }
        fallen |= watched(state).isFallen();
        see(start, state);
    }

    /**
     * Selects the robot whose falls are detected.
     *
     * @param state the true state
     * @return the state of the robot; by default that of the first robot
     */
    protected BodyState watched(WorldState state) {
        return state.robot();
    }

    /**
     * Observes the true state after a cycle.
     *
     * @param first the first observed state
     * @param now the current state
     */
    protected abstract void see(WorldState first, WorldState now);

    /** {@return whether the robot has fallen since the first state, even if it has since got up again} */
    public final boolean hasFallen() {
        return fallen;
    }
}
