package org.robonewbie.learning.design;

import java.util.List;
import org.robonewbie.learning.search.SearchPlan;
import org.robonewbie.learning.trial.Lying;
import org.robonewbie.learning.trial.TrialObserver;
import org.robonewbie.learning.trial.TrialRobot;
import org.robonewbie.nao.motion.Motion;

/** Rolling over from one side to another: a sketch whose keyframes are searched for. */
public final class RollOverDesign implements MotionDesign {

    private final Sketch sketch;
    private final String does;
    private final Lying from;
    private final SearchPlan plan;

    /**
     * Describes how to roll onto the back.
     *
     * @param name name of the motion and of its sketch
     * @param does what the robot does
     * @param from how the robot lies at first
     * @param plan how it is searched for
     */
    public RollOverDesign(String name, String does, Lying from, SearchPlan plan) {
        this.sketch = Sketch.load(name, joint -> !joint.name().startsWith("NECK_"));
        this.does = does;
        this.from = from;
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
        return List.of(new DescribedMotion(sketch.motion(coordinates), does, from.words(), Lying.ON_BACK.words()));
    }

    @Override
    public double cost(double[] coordinates, long seed) {
        Motion motion = sketch.motion(coordinates);
        TrialRobot robot = from.fallen(seed);
        double[] best = {-1};
        TrialObserver chest = seen -> {
            best[0] = Math.max(best[0], seen.chestUp());
            return true;
        };
        robot.play(motion, chest);
        robot.hold(0.4, chest);
        return (Lying.ON_BACK.isTrueOf(robot) ? -2 : 0)
                - best[0]
                - 0.5 * robot.chestUp()
                + 0.05 * motion.durationMillis() / 1000.0
                + 0.002 * sketch.degreesBeyondRange(coordinates);
    }
}
