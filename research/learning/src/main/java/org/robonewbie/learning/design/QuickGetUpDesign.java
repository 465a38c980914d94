package org.robonewbie.learning.design;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import org.robonewbie.learning.rehearsal.FallenRobot;
import org.robonewbie.learning.rehearsal.GetUpTrial;
import org.robonewbie.learning.rehearsal.Lying;
import org.robonewbie.learning.search.CovarianceMatrixAdaptation;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.file.MotionFiles;

/**
 * The search for a way to get up in little time. Robots of some builds fall once and lie there; each candidate gets up from the same falls
 * as the others of its generation, and the better half from as many others. Two of three trials begin with a fall from which the motion
 * that has been found so far does not get up: that is what made the search sure. In every third one friction and mass are a bit other than
 * usual, and a hand pushes. Seconds beyond a limit cost so much that the search becomes quick first.
 *
 * <p>A robot that stands, but with its feet too far apart for the stance, has nearly done it: friction holds them there. That costs less
 * than a fall, and the more the further they are apart.
 */
public final class QuickGetUpDesign {

    private static final double STEP = 0.2;
    private static final int POPULATION = 18;
    private static final int GENERATIONS_BETWEEN_EXAMS = 15;
    private static final double HARDNESS = 0.2;
    private static final double SETTLING_SECONDS = 0.5;
    private static final double COST_OF_SECOND = 4;
    private static final double FREE_CHANGE = 12;
    private static final double COST_OF_CHANGE = 0.02;
    private static final double COST_BEYOND_MOTORS = 0.0005;
    private static final double WHOLE_PROMISE = 3.6;
    private static final double NEARLY = 3.4;

    private final SymmetricKeyframes space;
    private final double freeSeconds;
    private final PractisedFalls falls;

    private QuickGetUpDesign(Motion first, double freeSeconds, PractisedFalls falls) {
        this.space = new SymmetricKeyframes(first);
        this.freeSeconds = freeSeconds;
        this.falls = falls;
    }

    /**
     * Goes on with the search from a motion file, and writes what it finds into it after each generation.
     *
     * @param arguments the file, {@code back} or {@code front}, robot types such as {@code 0,4}, seconds that cost nothing, seed, and
     *     number of generations
     * @throws IOException if the file cannot be read or written
     */
    public static void main(String[] arguments) throws IOException {
        Path file = Path.of(arguments[0]);
        Lying lying = arguments[1].equals("back") ? Lying.ON_BACK : Lying.ON_FRONT;
        List<RobotType> types = Arrays.stream(arguments[2].split(","))
                .map(type -> RobotType.values()[Integer.parseInt(type)])
                .toList();
        MotionFile given = MotionFiles.load(file);
        long seed = Long.parseLong(arguments[4]);
        PractisedFalls falls = new PractisedFalls(lying, types, seed);
        new QuickGetUpDesign(given.motion(), Double.parseDouble(arguments[3]), falls)
                .search(given, file, seed, Integer.parseInt(arguments[5]));
    }

    private void search(MotionFile given, Path file, long seed, int generations) throws IOException {
        CovarianceMatrixAdaptation cloud =
                new CovarianceMatrixAdaptation(new double[space.dimension()], STEP, POPULATION, seed);
        for (int i = 0; i < generations; i++) {
            if (i % GENERATIONS_BETWEEN_EXAMS == 0) {
                int up = falls.examine(space.motion(cloud.mean()), SETTLING_SECONDS);
                System.out.println("Gets up from " + up + " falls.");
            }
            List<double[]> candidates = cloud.ask();
            cloud.tell(costs(candidates, i));
            Motion found = space.motion(cloud.mean());
            System.out.printf(Locale.ROOT, "%4d  %.2f s%n", i, found.durationMillis() / 1000.0);
            MotionFiles.save(given.withKeyframes(found.keyframes()), file);
        }
    }

    private double[] costs(List<double[]> candidates, int generation) {
        List<FallenRobot> some = falls.draw();
        List<FallenRobot> others = falls.draw();
        return Costs.betterHalfTwice(
                candidates, x -> cost(x, some, 2L * generation), x -> cost(x, others, 2L * generation + 1));
    }

    private double cost(double[] x, List<FallenRobot> robots, long seed) {
        Motion motion = space.motion(x);
        double trials = IntStream.range(0, robots.size())
                .mapToObj(i -> robots.get(i).getUp(motion, 100 * seed + i, i % 3 == 1 ? HARDNESS : 0, SETTLING_SECONDS))
                .mapToDouble(QuickGetUpDesign::cost)
                .average()
                .orElseThrow();
        return trials
                + COST_OF_SECOND * Math.max(0, motion.durationMillis() / 1000.0 - freeSeconds)
                + COST_BEYOND_MOTORS * Costs.degreesBeyondMotors(motion)
                + COST_OF_CHANGE * Costs.excess(x, FREE_CHANGE);
    }

    private static double cost(GetUpTrial trial) {
        double rough = 0.001 * trial.rocking() + 0.01 * trial.jointsAtLimit();
        if (trial.success()) {
            return rough;
        }
        if (trial.lastPromise() > NEARLY) {
            return rough + 0.4 + 0.1 * Math.min(20, trial.degreesBeside());
        }
        return rough + 2.5 + 0.4 * (2 * WHOLE_PROMISE - trial.lastPromise() - trial.bestPromise());
    }
}
