package org.robonewbie.learning.design;

import java.util.Arrays;
import java.util.Locale;
import java.util.Random;
import java.util.stream.Collectors;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.learning.rehearsal.WalkTrial;
import org.robonewbie.learning.search.CostFunction;
import org.robonewbie.learning.search.Search;
import org.robonewbie.learning.search.SearchPlan;

/**
 * The search for the numbers of the walk engine: in some trials it walks straight as fast as it can, in others in circles and
 * sideways, in others it is commanded at random, and it must stay on its feet in all of them.
 *
 * @param stepMillis time of one step
 * @param slip factors by which the feet are set further than the robot is to get
 * @param most the largest speeds
 * @param newtons strength of the pushes
 */
public record EngineDesign(int stepMillis, WalkVelocity slip, WalkVelocity most, double newtons)
        implements CostFunction {

    /** What the next round of the search tries: stronger pushes than the rounds before, which had 4 and 5 N. */
    public static final EngineDesign NEXT =
            new EngineDesign(200, new WalkVelocity(1, 1, 1), new WalkVelocity(0.75, 0.3, 90), 11);

    private static final SearchPlan PLAN = new SearchPlan(1, 0.15, 16, 45, 4, 2);
    private static final double SECONDS = 7;

    /**
     * Goes on with the search that led to the shipped walk, and prints the coordinates that it finds; to ship them, put them
     * into {@link WalkStyle}. Three rounds have led there so far: steps of 240 ms towards 0.55 m/s from the gait of {@code
     * walk-forward-fast}, steps of 200 ms towards 0.72 m/s, and towards 0.75 m/s with curves.
     *
     * @param arguments none
     */
    public static void main(String[] arguments) {
        new Search(PLAN, NEXT).run(WalkStyle.coordinates(), progress -> {
            System.out.println(progress);
            System.out.println(text(progress.mean()));
        });
    }

    private static String text(double[] coordinates) {
        return Arrays.stream(coordinates)
                .mapToObj(x -> String.format(Locale.ROOT, "%.2f", x))
                .collect(Collectors.joining(", "));
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
        return Costs.roughness(trial.poise()) + (trial.stood() ? 0 : 6 - 3 * trial.seconds() / trial.planned());
    }
}
