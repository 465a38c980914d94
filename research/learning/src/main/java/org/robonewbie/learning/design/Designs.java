package org.robonewbie.learning.design;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.robonewbie.agent.walk.Gait;
import org.robonewbie.learning.rehearsal.Lying;
import org.robonewbie.learning.search.SearchPlan;
import org.robonewbie.nao.geometry.Pose2d;

/** All designs of the library, with the first guesses and plans that led to the shipped files. */
public final class Designs {

    private static final double[] WALK = {
        -0.32, -1.62, 0.87, -0.5, 0.65, -0.39, 1.02, 0.18, 1.26, 0.03, 0.29, -0.99, 1.26, -1.19, 3.3
    };
    private static final double[] FAST = {
        -0.51, -1.75, 2.51, 0.42, 2.01, -0.2, -1.82, 0.3, 0.66, -1.01, -2.44, -0.6, 1.63, -0.22, 6.56
    };
    private static final double[] KICK = {
        -0.8, -3.9, -1.3, -3.2, 1.1, -0.1, 0.9, -3.4, 1.4, -3.1, 1.3, -0.7, -2.7, 1.2, -4.9, 3.8, -1.0, 2.6, -0.4, 1.4,
        -0.4, 2.0, 0.2, -1.6, 2.2, -1.3, 1.9, 1.8, 1.3, -0.3, -0.7, -2.2
    };
    private static final double[] PASS = {
        -2, -1, 4, -1, 0.4, 1.3, -0.3, -2.5, 0.4, -2.6, 2.9, -0.1, -3, 0.5, -4, 1, -1.2, 2, -0.1
    };
    private static final Gait GAIT = Gait.of(320, 8, WALK);
    private static final Map<String, Supplier<MotionDesign>> ALL = new TreeMap<>(Map.ofEntries(
            Map.entry(
                    "walk-forward",
                    () -> new WalkDesign(
                            "walk-forward", false, 320, 8, 0.2, 330, WALK, new SearchPlan(1, 0.2, 12, 30, 4, 3))),
            Map.entry(
                    "walk-forward-fast",
                    () -> new WalkDesign(
                            "walk-forward-fast", true, 320, 8, 0.42, 180, FAST, new SearchPlan(1, 0.1, 12, 24, 5, 3))),
            Map.entry(
                    "turn-left",
                    () -> new FootworkDesign(
                            "turn-left",
                            "turns by 30 degrees to the left on the spot",
                            GAIT,
                            foot -> new Pose2d(0, 0, 10.65).then(foot.x(), foot.y(), foot.degrees()),
                            3)),
            Map.entry(
                    "turn-left-small",
                    () -> new FootworkDesign(
                            "turn-left-small",
                            "turns by 7 degrees to the left on the spot",
                            GAIT,
                            foot -> new Pose2d(0, 0, 7.2).then(foot.x(), foot.y(), foot.degrees()),
                            1)),
            Map.entry(
                    "side-step-left",
                    () -> new FootworkDesign(
                            "side-step-left",
                            "steps 8 cm to the left",
                            GAIT,
                            foot -> new Pose2d(foot.x(), foot.y() + 0.05, foot.degrees()),
                            2)),
            Map.entry(
                    "kick-right",
                    () -> new KickDesign(
                            "kick-right",
                            "kicks the ball hard with the right foot",
                            5.6,
                            KICK,
                            new SearchPlan(1, 0.05, 12, 12, 6, 2))),
            Map.entry(
                    "pass-right",
                    () -> new KickDesign(
                            "pass-right",
                            "passes the ball with the right foot",
                            1.5,
                            PASS,
                            new SearchPlan(1, 0.2, 12, 30, 4, 2))),
            Map.entry("stand-up-from-left-side", SideGetUpDesign::new),
            Map.entry("dance", DanceDesign::new),
            Map.entry("dive-left", () -> new DiveDesign("dive-left", new SearchPlan(1, 0.8, 14, 60, 3, 4))),
            Map.entry(
                    "roll-over-to-back",
                    () -> new RollOverDesign(
                            "roll-over-to-back",
                            "rolls over from the front to the back",
                            Lying.ON_FRONT,
                            new SearchPlan(1, 0.25, 12, 40, 6, 4))),
            Map.entry(
                    "stand-up-from-back",
                    () -> new GetUpDesign("stand-up-from-back", Lying.ON_BACK, new SearchPlan(2, 0.12, 14, 40, 8, 2))),
            Map.entry(
                    "stand-up-from-front",
                    () -> new GetUpDesign(
                            "stand-up-from-front", Lying.ON_FRONT, new SearchPlan(1, 0.12, 14, 40, 6, 2)))));

    private Designs() {}

    /** {@return the names of the designs in alphabetical order} */
    public static List<String> names() {
        return List.copyOf(ALL.keySet());
    }

    /**
     * Looks up a design.
     *
     * @param name its name, that of its first motion
     * @return the design
     * @throws IllegalArgumentException if there is none of this name
     */
    public static MotionDesign named(String name) {
        Supplier<MotionDesign> design = ALL.get(name);
        if (design == null) {
            throw new IllegalArgumentException("There is no design \"" + name + "\". Known are: " + names());
        }
        return design.get();
    }
}
