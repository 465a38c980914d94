package org.robonewbie.learning.design;

import java.util.List;
import org.robonewbie.learning.search.SearchPlan;

/** A design that is not searched for: it is what it was drawn as. */
abstract class DrawnDesign implements MotionDesign {

    @Override
    public final double[] start() {
        return new double[] {0};
    }

    @Override
    public final SearchPlan plan() {
        return SearchPlan.NONE;
    }

    @Override
    public final double cost(double[] candidate, long seed) {
        return 0;
    }

    @Override
    public final List<DescribedMotion> motions(double[] coordinates) {
        return motions();
    }

    /** Draws the motions. */
    abstract List<DescribedMotion> motions();
}
