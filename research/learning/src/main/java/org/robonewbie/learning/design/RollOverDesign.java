package org.robonewbie.learning.design;

import java.util.List;
import org.robonewbie.learning.rehearsal.Lying;
import org.robonewbie.learning.rehearsal.Rehearsal;
import org.robonewbie.learning.search.SearchPlan;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.trial.Measure;
import org.robonewbie.trial.WorldState;

/** Rolling over from one side to another: a sketch whose keyframes are searched for. */
public final class RollOverDesign extends SketchedDesign {

    private static final Vector3 FORWARD = new Vector3(1, 0, 0);

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
        try (Rehearsal robot = from.fallen(seed)) {
            ChestUp chest = new ChestUp();
            robot.watch(chest);
            robot.play(motion);
            robot.hold(0.4);
            return (Lying.ON_BACK.isTrueOf(robot.body()) ? -2 : 0)
                    - chest.most
                    - 0.5 * chest.now
                    + 0.05 * motion.durationMillis() / 1000.0;
        }
    }

    /** The upward component of the chest's direction: 1 straight up, -1 straight down. */
    private static final class ChestUp implements Measure {

        private double most = -1;
        private double now;

        @Override
        public void see(WorldState state) {
            now = state.robot().torso().rotation().apply(FORWARD).z();
            most = Math.max(most, now);
        }

        @Override
        public double value() {
            return most;
        }
    }
}
