package org.robonewbie.learning.design;

import java.util.List;
import org.robonewbie.learning.rehearsal.GetUpTrial;
import org.robonewbie.learning.rehearsal.Lying;
import org.robonewbie.learning.search.SearchPlan;
import org.robonewbie.nao.motion.Motion;

/** Getting up from one side: a sketch whose keyframes are searched for until the robot stands after every fall. */
public final class GetUpDesign extends SketchedDesign {

    private final Lying lying;

    /**
     * Describes how to get up.
     *
     * @param name name of the motion and of its sketch
     * @param lying how the robot lies at first
     * @param plan how it is searched for
     */
    public GetUpDesign(String name, Lying lying, SearchPlan plan) {
        super(name, plan);
        this.lying = lying;
    }

    @Override
    List<DescribedMotion> described(Motion motion) {
        return List.of(new DescribedMotion(motion, "gets up", lying.words(), "stance"));
    }

    @Override
    double cost(Motion motion, long seed) {
        GetUpTrial trial = GetUpTrial.run(lying, motion, seed);
        return (trial.success() ? -4 : 0)
                - trial.lastPromise()
                - 0.7 * trial.bestPromise()
                + 0.05 * motion.durationMillis() / 1000.0
                + 0.002 * trial.rocking()
                + 0.05 * trial.jointsAtLimit();
    }
}
