package org.robonewbie.learning.gym;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.WorldState;

/**
 * Follow a commanded velocity, another one every 3 s. Each second pays 1, less the error of the velocity in the last 0.4 s (1 for 0.3
 * m/s or 90°/s, together 1.5 at most); a fall costs 5, so that a dive never pays. The options {@code forward}, {@code left}
 * and {@code turn} set one command for the whole episode.
 */
class GymFollow extends GymCommandedTask {

    private static final WalkVelocity MOST = new WalkVelocity(0.8, 0.2, 90);
    private static final double BACKWARD = 0.3;
    private static final int WINDOW = 20;
    private static final double USUAL_METRES_PER_SECOND = 0.3;
    private static final double DEGREES_PER_SECOND = 90;
    private static final double MOST_ERROR = 1.5;
    private static final double FOR_A_FALL = 5;
    private static final double DONE_PART = 0.5;

    private final Deque<Pose2d> places = new ArrayDeque<>();
    private final double toleratedMetresPerSecond;
    private double earned;
    private double possible;

    /** Creates the task. */
    GymFollow() {
        this(USUAL_METRES_PER_SECOND);
    }

    /** Creates a task in which an error of the velocity of this size costs all that can be earned. */
    GymFollow(double toleratedMetresPerSecond) {
        this.toleratedMetresPerSecond = toleratedMetresPerSecond;
    }

    @Override
    WalkVelocity any(RandomSource random, WalkVelocity before) {
        return new WalkVelocity(
                        random.between(-BACKWARD, MOST.forward()),
                        random.between(-MOST.left(), MOST.left()),
                        random.between(-MOST.turn(), MOST.turn()))
                .within(MOST, BACKWARD);
    }

    @Override
    public double rangeDegrees() {
        return 40;
    }

    @Override
    public List<ObservedQuantity> extraQuantities() {
        return List.of(
                new ObservedQuantity("command.forward", "m/s", -GymOptions.MOST_SPEED, GymOptions.MOST_SPEED),
                new ObservedQuantity("command.left", "m/s", -GymOptions.MOST_SPEED, GymOptions.MOST_SPEED),
                new ObservedQuantity("command.turn", "degrees/s", -GymOptions.MOST_TURN, GymOptions.MOST_TURN));
    }

    @Override
    public double[] extras() {
        return new double[] {velocity().forward(), velocity().left(), velocity().turn()};
    }

    @Override
    protected void see(WorldState first, WorldState now) {
        places.addLast(now.place(robot()));
        if (places.size() > WINDOW) {
            possible += Cycle.SECONDS;
            earned += Cycle.SECONDS * (1 - lost(places.removeFirst(), places.getLast()));
        }
    }

    /** The error between two places, seen from half-way between their headings. */
    private double lost(Pose2d before, Pose2d now) {
        double seconds = WINDOW * Cycle.SECONDS;
        double turned = Angles.wrap(now.degrees() - before.degrees());
        Pose2d middle = new Pose2d(before.x(), before.y(), before.degrees() + turned / 2);
        double error = PortableMath.hypot(
                middle.ahead(now.point(0, 0, 0)) / seconds - velocity().forward(),
                middle.left(now.point(0, 0, 0)) / seconds - velocity().left());
        double turnError = Math.abs(turned / seconds - velocity().turn());
        return Math.min(MOST_ERROR, error / toleratedMetresPerSecond + turnError / DEGREES_PER_SECOND);
    }

    /** {@return whether the robot is on its feet and has earned half of what it could: a mean error of 0.15 m/s, or of 45°/s, or a part of both} */
    @Override
    public boolean isDone() {
        return !hasFallen() && possible > 0 && earned >= DONE_PART * possible;
    }

    @Override
    public double value() {
        return earned - (hasFallen() ? FOR_A_FALL : 0);
    }
}
