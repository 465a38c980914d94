package org.robonewbie.learning.design;

import java.util.List;
import org.robonewbie.learning.search.SearchPlan;
import org.robonewbie.learning.trial.DiveTrial;
import org.robonewbie.nao.motion.Motion;

/** A goalkeeper's dive to the left: a sketch whose keyframes are searched for; to the right it is the mirror image. */
public final class DiveDesign implements MotionDesign {

    private final Sketch sketch;
    private final SearchPlan plan;

    /**
     * Describes the dive.
     *
     * @param name name of the motion and of its sketch
     * @param plan how it is searched for
     */
    public DiveDesign(String name, SearchPlan plan) {
        this.sketch = Sketch.load(name, joint -> !joint.name().startsWith("NECK_"));
        this.plan = plan;
    }

    @Override
    public double[] start() {
        return sketch.coordinates();
    }

    @Override
    public SearchPlan plan() {
        return plan;
    }

    @Override
    public List<DescribedMotion> motions(double[] coordinates) {
        var dive = new DescribedMotion(
                sketch.motion(coordinates), "throws itself to the left to stop a ball", "stance", "lying on back");
        return List.of(dive, dive.mirrored());
    }

    @Override
    public double cost(double[] coordinates, long seed) {
        Motion motion = sketch.motion(coordinates);
        DiveTrial trial = DiveTrial.run(motion, seed, 1);
        return (trial.blocked() ? -1 : 0)
                - 2 * trial.reachInTime()
                + 0.05 * trial.jointsAtLimit()
                + 0.002 * sketch.degreesBeyondRange(coordinates);
    }
}
