package org.robonewbie.learning.design;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.DoubleStream;
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
 * as the others of its generation, and the better half from as many others. In every second trial friction and mass are a bit other than
 * usual, and a hand pushes. Seconds beyond a limit cost so much that the search first becomes quick and then sure.
 *
 * <p>A robot that stands, but with its feet too far apart for the stance, has nearly done it: friction holds them there. That costs less
 * than a fall, and the more the further they are apart.
 */
public final class QuickGetUpDesign {

    private static final double STEP = 0.25;
    private static final int POPULATION = 18;
    private static final int FALLS = 60;
    private static final int FALLS_OF_A_ROUND = 2;
    private static final double HARDNESS = 0.2;
    private static final double SETTLING_SECONDS = 0.5;
    private static final double COST_OF_SECOND = 4;
    private static final double FREE_CHANGE = 12;
    private static final double COST_OF_CHANGE = 0.02;
    private static final double COST_BEYOND_MOTORS = 0.0005;
    private static final double WHOLE_PROMISE = 3.6;
    private static final double NEARLY = 3.4;
    private static final long FIRST_FALL = 100_000;

    private final Motion first;
    private final double freeSeconds;
    private final List<List<FallenRobot>> robots;

    private QuickGetUpDesign(Motion first, Lying lying, List<RobotType> types, double freeSeconds) {
        this.first = first;
        this.freeSeconds = freeSeconds;
        this.robots = types.stream().map(type -> falls(lying, type)).toList();
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
        QuickGetUpDesign design = new QuickGetUpDesign(given.motion(), lying, types, Double.parseDouble(arguments[3]));
        design.search(given, file, Long.parseLong(arguments[4]), Integer.parseInt(arguments[5]));
    }

    private void search(MotionFile given, Path file, long seed, int generations) throws IOException {
        SymmetricKeyframes space = new SymmetricKeyframes(first);
        CovarianceMatrixAdaptation cloud =
                new CovarianceMatrixAdaptation(new double[space.dimension()], STEP, POPULATION, seed);
        for (int i = 0; i < generations; i++) {
            List<double[]> candidates = cloud.ask();
            double[] costs = costs(space, candidates, i);
            cloud.tell(costs);
            Motion found = space.motion(cloud.mean());
            double least = Arrays.stream(costs).min().orElseThrow();
            System.out.printf(Locale.ROOT, "%4d  %.3f  %.2f s%n", i, least, found.durationMillis() / 1000.0);
            save(given, found, file);
        }
    }

    private static void save(MotionFile given, Motion found, Path file) throws IOException {
        MotionFile changed = given;
        for (int i = 0; i < found.keyframes().size(); i++) {
            changed = changed.withKeyframe(i, found.keyframes().get(i));
        }
        MotionFiles.save(changed, file);
    }

    /** The better half is tried twice; the others rank behind it. */
    private double[] costs(SymmetricKeyframes space, List<double[]> candidates, int generation) {
        double[] once = candidates.stream()
                .mapToDouble(x -> cost(space.motion(x), x, 2 * generation))
                .toArray();
        double median = DoubleStream.of(once).sorted().toArray()[once.length / 2];
        return IntStream.range(0, once.length)
                .mapToDouble(i -> once[i] < median
                        ? (once[i] + cost(space.motion(candidates.get(i)), candidates.get(i), 2 * generation + 1)) / 2
                        : 100 + once[i])
                .toArray();
    }

    private double cost(Motion motion, double[] x, int round) {
        double trials = IntStream.range(0, FALLS_OF_A_ROUND)
                .boxed()
                .flatMapToDouble(i -> robots.stream().mapToDouble(falls -> {
                    FallenRobot robot = falls.get((round * FALLS_OF_A_ROUND + i) % FALLS);
                    return cost(robot.getUp(motion, 100L * round + i, i % 2 == 0 ? HARDNESS : 0, SETTLING_SECONDS));
                }))
                .average()
                .orElseThrow();
        double far = Arrays.stream(x)
                .map(each -> Math.max(0, Math.abs(each) - FREE_CHANGE))
                .sum();
        return trials
                + COST_OF_SECOND * Math.max(0, motion.durationMillis() / 1000.0 - freeSeconds)
                + COST_BEYOND_MOTORS * Costs.degreesBeyondMotors(motion)
                + COST_OF_CHANGE * far;
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

    private static List<FallenRobot> falls(Lying lying, RobotType type) {
        return IntStream.range(0, FALLS)
                .mapToObj(i -> fall(lying, type, FIRST_FALL + i, i % 4 == 3))
                .toList();
    }

    /** Some fall on purpose, the others with their arms anywhere. */
    private static FallenRobot fall(Lying lying, RobotType type, long seed, boolean onPurpose) {
        if (onPurpose) {
            FallenRobot robot = FallenRobot.after(type, lying == Lying.ON_BACK ? "fall-back" : "fall-forward", seed);
            if (robot.lies(lying)) {
                return robot;
            }
        }
        return FallenRobot.anyhow(lying, type, seed);
    }
}
