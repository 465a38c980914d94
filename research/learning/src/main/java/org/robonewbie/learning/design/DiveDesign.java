package org.robonewbie.learning.design;

import java.util.List;
import org.robonewbie.learning.rehearsal.DiveTrial;
import org.robonewbie.learning.search.SearchPlan;
import org.robonewbie.nao.motion.Motion;

/** A goalkeeper's dive to the left: a sketch whose keyframes are searched for; to the right it is the mirror image. */
public final class DiveDesign extends SketchedDesign {

    /**
     * Describes the dive.
     *
     * @param name name of the motion and of its sketch
     * @param plan how it is searched for
     */
    public DiveDesign(String name, SearchPlan plan) {
        super(name, plan);
    }

    @Override
    List<DescribedMotion> described(Motion motion) {
        var dive = new DescribedMotion(motion, "throws itself to the left to stop a ball", "stance", "lying on back");
        return List.of(dive, dive.mirrored());
    }

    @Override
    double cost(Motion motion, long seed) {
        DiveTrial trial = DiveTrial.run(motion, seed, 1);
        return (trial.blocked() ? -1 : 0) - 2 * trial.reachInTime() + 0.05 * trial.jointsAtLimit();
    }
}
