package org.robonewbie.learning.design;

import java.util.Arrays;
import java.util.Locale;
import java.util.Random;
import java.util.stream.Collectors;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.learning.search.Search;
import org.robonewbie.learning.search.SearchPlan;
import org.robonewbie.learning.search.Trial;
import org.robonewbie.learning.trial.WalkTrial;

/**
 * What the walk engine is searched for with: in some trials it walks straight on as fast as it can, in others in circles and
 * aside, in others it is commanded without any sense, and it must stay on its feet in all of them.
 *
 * @param stepMillis time of one step
 * @param slip by which factors the feet are set further than the robot shall get
 * @param most the largest speeds
 * @param newtons strength of the pushes
 */
public record EngineDesign(int stepMillis, WalkVelocity slip, WalkVelocity most, double newtons) implements Trial {

    /** What the shipped walk was searched for with, and how. */
    public static final EngineDesign STANDARD =
            new EngineDesign(200, new WalkVelocity(1, 1, 1), new WalkVelocity(0.75, 0.3, 90), 5);

    private static final SearchPlan PLAN = new SearchPlan(1, 0.1, 16, 20, 3, 2);
    private static final double[] START = {
        2.1, -1.5, 1.1, -1.3, 3.3, 0.3, -3.3, 0.1, 0.0, -0.3, -2.6, -0.5, 3.0, -1.4, 2.1, -0.2, -0.5, 0.7, 0.4, 0.1,
        -1.0, 1.2, 0.8, -0.8, 0.5, 3.0, 0.9, 0.1, -1.7, -0.0
    };
    private static final double SECONDS = 7;

    /**
     * Searches for the coordinates of {@link WalkStyle#STANDARD}, which must be put there by hand.
     *
     * @param arguments none
     */
    public static void main(String[] arguments) {
        double[] found = new Search(PLAN, STANDARD).run(START, System.out::println);
        System.out.println(Arrays.stream(found)
                .mapToObj(x -> String.format(Locale.ROOT, "%.2f", x))
                .collect(Collectors.joining(", ")));
    }

    @Override
    public double cost(double[] x, long seed) {
        WalkStyle style = WalkStyle.of(stepMillis, slip, most, x);
        return switch ((int) (seed % 3)) {
                    case 0 -> straight(style, seed);
                    case 1 -> curve(style, seed);
                    default -> cost(WalkTrial.erratic(style, SECONDS, seed, newtons));
                }
                + Costs.beyond(x, 6);
    }

    private double straight(WalkStyle style, long seed) {
        WalkVelocity ahead = new WalkVelocity(most.forward(), 0, 0);
        WalkTrial trial = WalkTrial.straight(style, ahead, SECONDS, seed, newtons);
        double speed = Math.max(0, Math.min(1, trial.forward() / trial.seconds() / most.forward()));
        return cost(trial) - 3 * speed + Math.min(1, Math.abs(trial.left()) / 3 + Math.abs(trial.turnedDegrees()) / 30);
    }

    /** Forward, aside and around at the same time; what is too much for one is slowed down by the engine. */
    private double curve(WalkStyle style, long seed) {
        Random random = new Random(3 * seed);
        random.nextLong();
        WalkVelocity velocity = new WalkVelocity(
                most.forward() * random.nextGaussian(),
                0.5 * most.left() * random.nextGaussian(),
                most.turn() * random.nextGaussian());
        WalkTrial trial = WalkTrial.straight(style, velocity, SECONDS, seed, newtons);
        double turn = velocity.within(most, style.backward()).turn() * trial.seconds();
        double missing = Math.abs(turn - trial.turnedDegrees()) / Math.max(90, Math.abs(turn));
        return cost(trial) + Math.min(1, missing);
    }

    private static double cost(WalkTrial trial) {
        return Costs.roughness(trial.watch()) + (trial.stood() ? 0 : 6 - 3 * trial.seconds() / trial.planned());
    }
}
