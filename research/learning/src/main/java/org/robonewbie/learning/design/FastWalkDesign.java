package org.robonewbie.learning.design;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import org.robonewbie.agent.walk.FastWalk;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.learning.rehearsal.WalkTrial;
import org.robonewbie.learning.search.CostFunction;
import org.robonewbie.learning.search.Search;
import org.robonewbie.learning.search.SearchFile;
import org.robonewbie.learning.search.SearchPlan;

/**
 * The search for the numbers of {@link WalkStyle#FAST}. Here the largest speeds are coordinates too, so the search itself finds
 * out how much the robot can be asked for. In half of the trials it walks straight on as fast as it can, in a quarter it turns on
 * the spot, in a quarter it is commanded at random.
 *
 * @param newtons strength of the pushes
 */
public record FastWalkDesign(double newtons) implements CostFunction {

    private static final SearchPlan PLAN = new SearchPlan(3, 0.3, 14, 80, 4, 2);
    private static final double PUSH_NEWTONS = 4;
    private static final double SECONDS = 6;
    private static final double TURN_SECONDS = 3;
    private static final double FULL_TURN_SPEED = 130;

    /**
     * Goes on with the search from a file, or from the shipped walk, and writes what it finds into that file after each
     * generation. Two rounds have led to the shipped numbers, on 23
     * November 2026: 280 generations from the standard walk (seed 2, less weight on the speed forward) and 81 with this plan, in
     * about 20 minutes on one core of a busy computer.
     *
     * @param arguments the file with the coordinates
     * @throws IOException if the file cannot be read or written
     */
    public static void main(String[] arguments) throws IOException {
        SearchFile.goOn(
                Path.of(arguments[0]), FastWalk.coordinates(), new Search(PLAN, new FastWalkDesign(PUSH_NEWTONS)));
    }

    @Override
    public double cost(double[] x, long seed) {
        WalkStyle style = FastWalk.style(x);
        return switch ((int) (seed % 4)) {
                    case 0, 2 -> straight(style, seed);
                    case 1 -> turn(style, seed);
                    default -> cost(WalkTrial.erratic(style, SECONDS, seed, newtons)) - 6;
                }
                + Costs.beyond(Arrays.copyOf(x, WalkStyle.PARAMETERS), 7);
    }

    private double straight(WalkStyle style, long seed) {
        WalkVelocity ahead = new WalkVelocity(style.most().forward(), 0, 0);
        WalkTrial trial = WalkTrial.straight(style, ahead, SECONDS, seed, newtons);
        double aside = Math.min(1, Math.abs(trial.left()) / 3 + Math.abs(trial.turnedDegrees()) / 30);
        return cost(trial) - 14 * trial.forward() / trial.planned() + aside;
    }

    private double turn(WalkStyle style, long seed) {
        double side = new Random(5 * seed).nextInt(1000) < 500 ? 1 : -1;
        WalkVelocity around = new WalkVelocity(0, 0, side * style.most().turn());
        WalkTrial trial = WalkTrial.straight(style, around, TURN_SECONDS, seed, newtons);
        double speed = side * trial.turnedDegrees() / trial.planned();
        double away = Math.min(1, Math.hypot(trial.left(), trial.forward()));
        return cost(trial) - 4 * Math.min(FULL_TURN_SPEED, speed) / 100 + away;
    }

    private static double cost(WalkTrial trial) {
        return 0.2 * Costs.roughness(trial.poise()) + (trial.stood() ? 0 : 6 - 3 * trial.seconds() / trial.planned());
    }
}
