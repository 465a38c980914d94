package org.robonewbie.learning.objective;

import org.jspecify.annotations.Nullable;

/** A gauge that compares with the start of the trial and knows when the robot has fallen. */
abstract class RememberingGauge implements Gauge {

    private @Nullable TrueState first;
    private boolean fallen;

    @Override
    public final void look(TrueState now) {
        if (first == null) {
            first = now;
        }
        fallen |= now.isFallen();
        measure(first, now, fallen);
    }

    /** Takes in one cycle. */
    abstract void measure(TrueState start, TrueState now, boolean hasFallen);
}
