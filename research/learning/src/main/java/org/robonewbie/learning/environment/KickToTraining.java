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
 * Kick the ball to a wanted distance by correcting the motion {@code kick-right}: each episode wants another distance, and
 * the option {@code distance} sets one. Return: 1 less the distance from where the ball will lie to where it is wanted, as a
 * part of the wanted distance (2 at most); −1 for a fall. Only the end counts.
 */
final class KickToTraining extends TrainingTask {

    private static final Motion KICK = ShippedMotions.motion("kick-right");
    private static final Scene SCENE = scene(-2).withBall(new Vector3(-2 + 0.209, -0.036, 0));
    private static final double SPREAD_METRES = 0.01;
    private static final double MIN_METRES = 2;
    private static final double MAX_METRES = 6;
    private static final double MAX_ERROR = 2;
    private static final double DONE_METRES = 0.5;

    private double wanted;
    private double error;

    @Override
    public Scene scene(RandomSource ofTheEpisode) {
        super.scene(ofTheEpisode);
        return SCENE;
    }

    @Override
    public void begin(Trial trial) {
        scatterBall(trial, SPREAD_METRES);
        if (wanted == 0) {
            wanted = random().between(MIN_METRES, MAX_METRES);
        }
    }

    @Override
    protected void takeDistance(double metres) {
        wanted = metres;
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
        return new double[] {wanted};
    }

    @Override
    protected void see(WorldState first, WorldState now) {
        Vector3 rest = KickDistance.restingPlace(now);
        Vector3 goal = first.ball()
                .plus(first.place().point(wanted, 0, 0).minus(first.place().point(0, 0, 0)));
        error = Math.hypot(rest.x() - goal.x(), rest.y() - goal.y());
    }

    /** {@return whether the ball will lie within half a metre of where it is wanted and the robot stays on its feet} */
    @Override
    public boolean isDone() {
        return !hasFallen() && error < DONE_METRES;
    }

    @Override
    public double value() {
        return 1 - Math.min(MAX_ERROR, error / wanted) - (hasFallen() ? 1 : 0);
    }
}
