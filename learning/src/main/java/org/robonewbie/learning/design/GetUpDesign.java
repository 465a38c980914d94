package org.robonewbie.learning.design;

import java.util.List;
import org.robonewbie.learning.search.SearchPlan;
import org.robonewbie.learning.trial.GetUpTrial;
import org.robonewbie.learning.trial.Lying;
import org.robonewbie.learning.trial.TrialObserver;
import org.robonewbie.nao.motion.Motion;

/** Getting up from one side: a sketch whose keyframes are searched for until the robot stands after every fall. */
public final class GetUpDesign implements MotionDesign {

    private final Sketch sketch;
    private final Lying lying;
    private final SearchPlan plan;

    /**
     * Describes how to get up.
     *
     * @param name name of the motion and of its sketch
     * @param lying how the robot lies at first
     * @param plan how it is searched for
     */
    public GetUpDesign(String name, Lying lying, SearchPlan plan) {
        this.sketch = Sketch.load(name, joint -> !joint.name().startsWith("NECK_"));
        this.lying = lying;
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
        return List.of(new DescribedMotion(sketch.motion(coordinates), "gets up", lying.words(), "stance"));
    }

    @Override
    public double cost(double[] coordinates, long seed) {
        Motion motion = sketch.motion(coordinates);
        GetUpTrial trial = GetUpTrial.run(lying.fallen(seed), List.of(motion), TrialObserver.NONE);
        return (trial.success() ? -4 : 0)
                - trial.lastPromise()
                - 0.7 * trial.bestPromise()
                + 0.05 * motion.durationMillis() / 1000.0
                + 0.002 * trial.rocking()
                + 0.05 * trial.jointsAtLimit()
                + 0.002 * sketch.degreesBeyondRange(coordinates);
    }
}
