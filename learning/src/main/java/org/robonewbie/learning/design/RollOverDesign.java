package org.robonewbie.learning.design;

import java.util.List;
import org.robonewbie.learning.search.SearchPlan;
import org.robonewbie.learning.trial.Lying;
import org.robonewbie.learning.trial.TrialObserver;
import org.robonewbie.learning.trial.TrialRobot;
import org.robonewbie.nao.motion.Motion;

/** Rolling over from one side to another: a sketch whose keyframes are searched for. */
public final class RollOverDesign extends SketchedDesign {

    private final String does;
    private final Lying from;

    /**
     * Describes how to roll onto the back.
     *
     * @param name name of the motion and of its sketch
     * @param does what the robot does
     * @param from how the robot lies at first
     * @param plan how it is searched for
     */
    public RollOverDesign(String name, String does, Lying from, SearchPlan plan) {
        super(name, plan);
        this.does = does;
        this.from = from;
    }

    @Override
    List<DescribedMotion> described(Motion motion) {
        return List.of(new DescribedMotion(motion, does, from.words(), Lying.ON_BACK.words()));
    }

    @Override
    double cost(Motion motion, long seed) {
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
                + 0.05 * motion.durationMillis() / 1000.0;
    }
}
