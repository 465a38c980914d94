package org.robonewbie.trial.measure;

import org.jspecify.annotations.Nullable;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.trial.Measure;
import org.robonewbie.trial.Moment;

/** A measure of one robot of a trial, the first one, that compares with the beginning and knows when the robot has fallen. */
public abstract class MeasureFromStart implements Measure {

    private @Nullable Moment start;
    private boolean fallen;

    /** Creates a measure that has not seen anything. */
    protected MeasureFromStart() {}

    @Override
    public final void see(Moment moment) {
        if (start == null) {
            start = moment;
        }
        fallen |= watched(moment).isFallen();
        see(start, moment);
    }

    /**
     * Chooses the robot whose falls count.
     *
     * @param moment what is true now
     * @return its body, that of the first robot unless a subclass says otherwise
     */
    protected BodyState watched(Moment moment) {
        return moment.robot();
    }

    /**
     * Looks at the truth after a cycle.
     *
     * @param first the first moment that this measure has seen
     * @param now what is true now
     */
    protected abstract void see(Moment first, Moment now);

    /** {@return whether the robot has fallen since the first moment, even if it has got up again} */
    public final boolean hasFallen() {
        return fallen;
    }
}
