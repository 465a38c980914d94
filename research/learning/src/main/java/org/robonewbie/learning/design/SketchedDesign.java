package org.robonewbie.learning.design;

import java.util.List;
import org.robonewbie.learning.search.SearchPlan;
import org.robonewbie.nao.motion.Motion;

/** A design that was drawn by hand as a {@link Sketch}, whose keyframes are searched for. */
abstract class SketchedDesign implements MotionDesign {

    private final Sketch sketch;
    private final SearchPlan plan;

    SketchedDesign(String name, SearchPlan plan) {
        this.sketch = Sketch.load(name, joint -> !joint.name().startsWith("NECK_"));
        this.plan = plan;
    }

    @Override
    public final double[] start() {
        return sketch.coordinates();
    }

    @Override
    public final SearchPlan plan() {
        return plan;
    }

    @Override
    public final List<DescribedMotion> motions(double[] coordinates) {
        return described(sketch.motion(coordinates));
    }

    @Override
    public final double cost(double[] coordinates, long seed) {
        return cost(sketch.motion(coordinates), seed) + 0.002 * sketch.degreesBeyondRange(coordinates);
    }

    /** Describes the motion, and adds its mirror image if there is one. */
    abstract List<DescribedMotion> described(Motion motion);

    /** Carries out a trial. */
    abstract double cost(Motion motion, long seed);
}
