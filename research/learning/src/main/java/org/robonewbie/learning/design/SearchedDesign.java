package org.robonewbie.learning.design;

import org.robonewbie.learning.search.SearchPlan;

/** A design whose coordinates have a meaning of their own and are searched for from a first guess. */
abstract class SearchedDesign implements MotionDesign {

    private final double[] start;
    private final SearchPlan plan;

    SearchedDesign(double[] start, SearchPlan plan) {
        this.start = start.clone();
        this.plan = plan;
    }

    @Override
    public final double[] start() {
        return start.clone();
    }

    @Override
    public final SearchPlan plan() {
        return plan;
    }
}
