package org.robonewbie.exercises;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/**
 * Task: dance on the spot to the beat of a swinging ball, moving at least three limbs without falling.
 *
 * <p>A joint counts as moving to the beat if at least half of the variance of its angle lies at the frequency of the ball, or
 * at half or twice that frequency. The variance is computed from the Fourier coefficients of these three frequencies over a
 * whole number of swings.
 */
final class DanceTask implements Task {

    private static final double BALL_METRES = 1.5;
    private static final double BALL_DEGREES = 35;
    private static final double JUDGED_FROM_SECONDS = 3;
    private static final double JUDGED_SECONDS = 12;
    private static final double MIN_SHARE = 0.5;
    private static final double MAX_METRES = 0.3;
    private static final int MIN_LIMBS = 3;

    private Pose2d start = new Pose2d(-1, 0, 0);
    private double period = 2;
    private final Map<Joint, List<Double>> angles = new EnumMap<>(Joint.class);
    private Vector3 first = Vector3.ZERO;
    private double travelled;
    private boolean fallen;

    /** A limb and the range in degrees through which one of its joints must move; the range is smaller for legs. */
    private enum Limb {
        HEAD(30),
        LEFT_ARM(30),
        RIGHT_ARM(30),
        LEFT_LEG(15),
        RIGHT_LEG(15);

        private final double degrees;

        Limb(double degrees) {
            this.degrees = degrees;
        }

        static Limb of(Joint joint) {
            String name = joint.name();
            if (name.startsWith("NECK")) {
                return HEAD;
            }
            boolean left = name.startsWith("LEFT");
            boolean leg = name.contains("HIP") || name.contains("KNEE") || name.contains("FOOT");
            return leg ? (left ? LEFT_LEG : RIGHT_LEG) : left ? LEFT_ARM : RIGHT_ARM;
        }
    }

    @Override
    public Scene scene(RandomSource random) {
        start = new Pose2d(random.between(-3, -1), random.between(-2, 2), random.between(-180, 180));
        period = 1.6 + 0.5 * Math.floorMod(random.seed(), 3L) + random.between(0, 0.1);
        return Scene.of(RobotStart.at(start).after("stand")).withBall(start.point(BALL_METRES, 0, 0));
    }

    @Override
    public void act(Trial trial) {
        double bearing = BALL_DEGREES * PortableMath.sin(2 * Math.PI * trial.seconds() / period);
        trial.placeBall(start.point(BALL_METRES, bearing, 0));
    }

    @Override
    public void see(WorldState state) {
        first = state.seconds() == 0 ? state.robot().position() : first;
        travelled = Math.max(travelled, state.place().distance(first));
        fallen |= state.robot().isFallen();
        if (state.seconds() > JUDGED_FROM_SECONDS) {
            for (Joint joint : Joint.values()) {
                angles.computeIfAbsent(joint, key -> new ArrayList<>())
                        .add(state.robot().degrees(joint));
            }
        }
    }

    @Override
    public boolean isDecided() {
        return fallen;
    }

    @Override
    public Score score() {
        int moving = limbs(false);
        int dancing = limbs(true);
        String finding = String.format(
                Locale.ROOT,
                "the ball swung once every %.1f s; %d limbs moved, %d of them in that rhythm;" + " %.2f m travelled%s",
                period,
                moving,
                dancing,
                travelled,
                fallen ? ", and a fall" : "");
        if (fallen) {
            return Score.failed(
                    Math.min(2, moving),
                    finding,
                    "Move the legs slowly and symmetrically; move the arms and head as you like.");
        }
        if (travelled > MAX_METRES) {
            return Score.failed(2, finding, "Dance on the spot: stay within 0.3 m of where you start.");
        }
        if (moving < MIN_LIMBS) {
            return Score.failed(
                    moving,
                    finding,
                    "At least three limbs have to move: head, arms (30° each) or legs (15°), from the third second on.");
        }
        return dancing >= MIN_LIMBS
                ? Score.passed(finding)
                : Score.failed(
                        3.0 + dancing,
                        finding,
                        "The ball beats time, at a different tempo in each trial. Let fieldView.ball().bearing()"
                                + " drive the swing, or measure how long a swing takes.");
    }

    private int limbs(boolean inRhythm) {
        return (int) Arrays.stream(Limb.values())
                .filter(limb -> angles.entrySet().stream()
                        .filter(moved -> Limb.of(moved.getKey()) == limb)
                        .map(Map.Entry::getValue)
                        .anyMatch(
                                degrees -> moves(degrees, limb.degrees) && (!inRhythm || share(degrees) >= MIN_SHARE)))
                .count();
    }

    private static boolean moves(List<Double> degrees, double least) {
        double lowest = degrees.stream().mapToDouble(Double::doubleValue).min().orElse(0);
        double highest = degrees.stream().mapToDouble(Double::doubleValue).max().orElse(0);
        return highest - lowest >= least;
    }

    /**
     * Returns the share of an angle's variance, 0 to 1, that lies at the ball's frequency, or at half or twice that
     * frequency.
     */
    private double share(List<Double> degrees) {
        double whole = 2 * period * Math.floor(JUDGED_SECONDS / (2 * period));
        int count = Math.min(degrees.size(), (int) Math.round(whole / Cycle.SECONDS));
        double mean = degrees.stream()
                .limit(count)
                .mapToDouble(Double::doubleValue)
                .average()
                .orElse(0);
        double all = 0;
        for (int i = 0; i < count; i++) {
            all += Math.pow(degrees.get(i) - mean, 2);
        }
        double rhythmic = 0;
        for (double times : List.of(0.5, 1.0, 2.0)) {
            double cosine = 0;
            double sine = 0;
            for (int i = 0; i < count; i++) {
                double angle = 2 * Math.PI * times * i * Cycle.SECONDS / period;
                cosine += (degrees.get(i) - mean) * PortableMath.cos(angle);
                sine += (degrees.get(i) - mean) * PortableMath.sin(angle);
            }
            rhythmic += 2 * (cosine * cosine + sine * sine) / count;
        }
        return all == 0 ? 0 : rhythmic / all;
    }
}
