package org.robonewbie.learning.environment;

import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.file.ShippedMotions;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;
import org.robonewbie.trial.measure.KickDistance;

/**
 * Task: kick the ball to a target distance by correcting the motion {@code kick-right}. Each episode draws the distance
 * unless the option {@code distance} sets it. Only the state at the end of the episode counts.
 */
final class KickToTraining extends TrainingTask {

    private static final Motion KICK = ShippedMotions.motion("kick-right");
    private static final Scene SCENE = scene(-2).withBall(new Vector3(-2 + 0.209, -0.036, 0));
    private static final double SPREAD_METRES = 0.01;
    private static final double MIN_METRES = 2;
    private static final double MAX_METRES = 6;
    private static final double MAX_ERROR = 2;
    private static final double DONE_METRES = 0.5;

    private double target;
    private double error;

    @Override
    public Scene scene(RandomSource random) {
        return SCENE;
    }

    @Override
    public void begin(Trial trial) {
        scatterBall(trial, SPREAD_METRES);
        if (target == 0) {
            target = random().between(MIN_METRES, MAX_METRES);
        }
    }

    @Override
    protected void setDistance(double metres) {
        target = metres;
    }

    @Override
    public Optional<Motion> motion() {
        return Optional.of(KICK);
    }

    @Override
    public double rangeDegrees() {
        return 30;
    }

    @Override
    public int longestCycles() {
        return 150;
    }

    @Override
    public List<ObservedQuantity> extraQuantities() {
        return List.of(new ObservedQuantity("command.distance", "m", 0, DomainRandomization.MAX_DISTANCE));
    }

    @Override
    public double[] extras() {
        return new double[] {target};
    }

    @Override
    protected void see(WorldState first, WorldState now) {
        Vector3 rest = KickDistance.restingPlace(now);
        Vector3 goal = first.ball()
                .plus(first.place().point(target, 0, 0).minus(first.place().point(0, 0, 0)));
        error = Math.hypot(rest.x() - goal.x(), rest.y() - goal.y());
    }

    /** {@return whether the ball comes to rest within half a metre of the target and the robot has not fallen} */
    @Override
    public boolean isDone() {
        return !hasFallen() && error < DONE_METRES;
    }

    @Override
    public String rewardRule() {
        return "1 minus the distance between where the ball will stop and its target, relative to the wanted "
                + "distance (at most 2); a fall costs 1";
    }

    @Override
    public String successRule() {
        return "the ball will stop within 0.5 m of the target and the robot stands";
    }

    @Override
    public double value() {
        return 1 - Math.min(MAX_ERROR, error / target) - (hasFallen() ? 1 : 0);
    }
}
