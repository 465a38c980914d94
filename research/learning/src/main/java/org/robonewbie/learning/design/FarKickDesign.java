package org.robonewbie.learning.design;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import org.robonewbie.learning.rehearsal.KickTrial;
import org.robonewbie.learning.search.CovarianceMatrixAdaptation;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.BallPlace;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.file.MotionFiles;

/**
 * The search for a kick that sends the ball as far as possible. It goes on from a motion file, in two stages.
 *
 * <p>A foot that is fast moves more than 10 cm in a cycle, so it depends on a centimetre whether it meets the ball squarely, and a search that
 * kicks a ball sees cliffs everywhere. The first stage, {@code swing}, therefore kicks into the air and calculates from the way of the foot where
 * the ball should lie and how far it would fly ({@link KickSwing}). The second stage, {@code ball}, kicks real balls that lie up to 2 cm
 * beside their place, and sees to it that the robot stands and the ball goes straight.
 */
public final class FarKickDesign {

    private static final int POPULATION = 20;
    private static final int TRIALS = 4;
    private static final int EXAM_TRIALS = 40;
    private static final long EXAM_SEED = 500;
    private static final int GENERATIONS_BETWEEN_EXAMS = 10;
    private static final double SCATTER_METRES = 0.012;
    private static final double PLENTY_METRES = 12;
    private static final double FREE_DEGREES = 1.5;
    private static final double DEGREES_PER_COST = 3;
    private static final double WORST_SHARE = 0.25;
    private static final double FREE_MILLIS = 1700;
    private static final double FREE_CHANGE = 12;
    private static final double COST_OF_CHANGE = 0.02;
    private static final double COST_OF_OVERLAP = 20;
    private static final double COST_BEYOND_MOTORS = 0.0002;

    private final KickKeyframes space;
    private final List<RobotType> types;
    private final double costOfFall;

    private FarKickDesign(MotionFile first, List<RobotType> types, double costOfFall) {
        this.space = new KickKeyframes(first.motion(), first.ball().orElseThrow());
        this.types = types;
        this.costOfFall = costOfFall;
    }

    /** A kick and the place of its ball. */
    private record Candidate(Motion motion, BallPlace ball, double cost) {}

    /**
     * Goes on with the search from a motion file, and writes into another one what passes an exam best.
     *
     * @param arguments the file, the file to write, {@code swing} or {@code ball}, robot types such as {@code 0,2}, seed, number of
     *     generations, spread of the first candidates, and what a fall costs in metres
     * @throws IOException if a file cannot be read or written
     */
    public static void main(String[] arguments) throws IOException {
        MotionFile given = MotionFiles.load(Path.of(arguments[0]));
        List<RobotType> types = Arrays.stream(arguments[3].split(","))
                .map(type -> RobotType.values()[Integer.parseInt(type)])
                .toList();
        FarKickDesign design = new FarKickDesign(given, types, Double.parseDouble(arguments[7]));
        boolean swings = arguments[2].equals("swing");
        int dimension = design.space.dimension();
        long seed = Long.parseLong(arguments[4]);
        var cloud = new CovarianceMatrixAdaptation(
                new double[dimension], Double.parseDouble(arguments[6]), POPULATION, seed);
        Random random = new Random(seed);
        double best = Double.POSITIVE_INFINITY;
        for (int i = 1; i <= Integer.parseInt(arguments[5]); i++) {
            List<Long> some = draw(random);
            List<Long> others = draw(random);
            List<double[]> asked = cloud.ask();
            cloud.tell(
                    swings
                            ? design.swings(asked, some)
                            : Costs.betterHalfTwice(asked, x -> design.kick(x, some), x -> design.kick(x, others)));
            if (i % GENERATIONS_BETWEEN_EXAMS == 0) {
                Candidate mean = swings ? design.swing(cloud.mean(), some) : design.aimed(cloud.mean());
                best = Math.min(best, design.examine(mean, i, best, given, Path.of(arguments[1])));
            }
        }
    }

    private static List<Long> draw(Random random) {
        return LongStream.generate(() -> 1000L + random.nextInt(1_000_000))
                .limit(TRIALS)
                .boxed()
                .toList();
    }

    private double[] swings(List<double[]> asked, List<Long> seeds) {
        return asked.stream().mapToDouble(x -> swing(x, seeds).cost).toArray();
    }

    /** Swings the leg without a ball, and looks for the best place of one. */
    private Candidate swing(double[] x, List<Long> seeds) {
        Motion motion = space.motion(x);
        List<KickSwing> swings = swings(motion, seeds);
        Candidate best = new Candidate(motion, space.ball(x), Double.POSITIVE_INFINITY);
        for (double ahead = 0.14; ahead < 0.345; ahead += 0.01) {
            for (double left = -0.1; left < 0.05; left += 0.02) {
                double cost = cost(swings, ahead, left);
                if (cost < best.cost) {
                    best = new Candidate(motion, KickKeyframes.rounded(ahead, left), cost);
                }
            }
        }
        return new Candidate(best.motion, best.ball, best.cost + falls(swings) + flaws(x, motion, swings.get(0)));
    }

    private List<KickSwing> swings(Motion motion, List<Long> seeds) {
        return IntStream.range(0, seeds.size())
                .mapToObj(i -> KickSwing.of(type(i), motion, seeds.get(i)))
                .toList();
    }

    /** The robots of the trials are of one type after the other. */
    private RobotType type(int trial) {
        return types.get(trial % types.size());
    }

    private static double cost(List<KickSwing> swings, double ahead, double left) {
        List<Double> costs = new ArrayList<>();
        for (KickSwing swing : swings) {
            for (int i = -1; i <= 1; i++) {
                for (int j = -1; j <= 1; j += 2) {
                    KickSwing.Shot shot = swing.shot(new BallPlace(ahead + 0.01 * i, left + 0.008 * j));
                    double aside =
                            shot.ahead() > 0 ? Math.abs(Math.toDegrees(Math.atan2(shot.left(), shot.ahead()))) : 0;
                    costs.add(Math.min(3, aside / 8) - shot.ahead());
                }
            }
        }
        return cautiousMean(costs);
    }

    private static double cautiousMean(List<Double> costs) {
        double mean = costs.stream().mapToDouble(cost -> cost).average().orElseThrow();
        double worst = costs.stream().mapToDouble(cost -> cost).max().orElseThrow();
        return mean + WORST_SHARE * (worst - mean);
    }

    private double falls(List<KickSwing> swings) {
        return swings.stream()
                .mapToDouble(swing -> swing.standing() ? 0 : costOfFall * (1 + swing.fallCost()))
                .average()
                .orElseThrow();
    }

    private double kick(double[] x, List<Long> seeds) {
        Motion motion = space.motion(x);
        List<Double> costs =
                kicks(motion, space.ball(x), seeds).stream().map(this::cost).toList();
        return cautiousMean(costs) + flaws(x, motion, KickSwing.of(type(0), motion, seeds.get(0)));
    }

    private List<KickTrial> kicks(Motion motion, BallPlace ball, List<Long> seeds) {
        return IntStream.range(0, seeds.size())
                .mapToObj(i -> kick(type(i), motion, ball, seeds.get(i)))
                .toList();
    }

    private static KickTrial kick(RobotType type, Motion motion, BallPlace ball, long seed) {
        Random random = new Random(31 * seed + 7);
        BallPlace near = new BallPlace(
                ball.ahead() + SCATTER_METRES * (2 * random.nextDouble() - 1),
                ball.left() + SCATTER_METRES * (2 * random.nextDouble() - 1));
        return KickTrial.quick(type, motion, near, seed);
    }

    private double cost(KickTrial trial) {
        return (trial.standing() ? 0 : costOfFall * (1 + trial.fallCost()))
                + Math.min(4, Math.max(0, Math.abs(trial.degreesAside()) - FREE_DEGREES) / DEGREES_PER_COST)
                - Math.min(PLENTY_METRES, trial.metres());
    }

    private static double flaws(double[] x, Motion motion, KickSwing swing) {
        return COST_OF_CHANGE * Costs.excess(x, FREE_CHANGE)
                + COST_OF_OVERLAP * swing.overlap()
                + COST_BEYOND_MOTORS * Costs.degreesBeyondMotors(motion)
                + Math.max(0, motion.durationMillis() - FREE_MILLIS) / 300;
    }

    private Candidate aimed(double[] x) {
        return new Candidate(space.motion(x), space.ball(x), 0);
    }

    /** Kicks some balls with the present mean; writes it if it is the best so far. */
    private double examine(Candidate mean, int generation, double best, MotionFile given, Path file)
            throws IOException {
        List<Long> seeds =
                LongStream.range(EXAM_SEED, EXAM_SEED + EXAM_TRIALS).boxed().toList();
        List<KickTrial> trials = kicks(mean.motion, mean.ball, seeds);
        KickSwing swing = KickSwing.of(type(0), mean.motion, EXAM_SEED);
        double cost = cautiousMean(trials.stream().map(this::cost).toList()) + flaws(new double[0], mean.motion, swing);
        System.out.printf(
                Locale.ROOT,
                "%4d  cost %.2f, %.2f m on average, %.2f m at least, %d of %d stand, %d within 5°, overlap %.3f, %d ms, ball %s%n",
                generation,
                cost,
                trials.stream().mapToDouble(KickTrial::metres).average().orElseThrow(),
                trials.stream().mapToDouble(KickTrial::metres).min().orElseThrow(),
                trials.stream().filter(KickTrial::standing).count(),
                EXAM_TRIALS,
                trials.stream()
                        .filter(trial -> Math.abs(trial.degreesAside()) < 5)
                        .count(),
                swing.overlap(),
                mean.motion.durationMillis(),
                mean.ball);
        if (cost < best) {
            save(given, mean, file);
        }
        return cost;
    }

    private static void save(MotionFile given, Candidate found, Path file) throws IOException {
        MotionFile changed = given.withKeyframes(found.motion.keyframes());
        MotionFiles.save(changed.withProperty("ball", found.ball.toString()), file);
    }
}
