package org.robonewbie.learning.gym;

import java.util.Optional;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.walk.LearnedReflex;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.trial.Moment;
import org.robonewbie.trial.Place;
import org.robonewbie.trial.Trial;

/**
 * Run straight ahead for 10 s by correcting the walk engine, which is asked for more than it can do: a robot that corrects nothing
 * falls within two seconds. It pays 1 per metre along the first heading, and a fall costs 3. Someone pushes the robot at the
 * beginning, from in front or from behind.
 */
final class GymEngineRun extends GymTask {

    private static final double LEAST = 0.7;
    private static final double MOST = 1.1;
    private static final double FOR_A_FALL = 3;
    private static final double MOST_NEWTONS = 40;
    private static final double GOAL_METRES = 5;

    private Optional<WalkVelocity> wanted = Optional.empty();
    private double metres;

    @Override
    public Optional<Policy> walk() {
        return Optional.of(WalkGuide.ENGINE);
    }

    @Override
    public double rangeDegrees() {
        return LearnedReflex.RANGE_DEGREES;
    }

    @Override
    protected void takeCommand(WalkVelocity command) {
        wanted = Optional.of(command);
    }

    @Override
    public void begin(Trial trial) {
        if (wanted.isEmpty()) {
            wanted = Optional.of(new WalkVelocity(chance().between(LEAST, MOST), 0, 0));
        }
        Place centre = new Place(0, 0, chance().between(-180, 180));
        trial.robot(0).push(centre.point(chance().between(0, MOST_NEWTONS), 0, 0));
    }

    @Override
    protected WalkVelocity velocity() {
        return wanted.orElse(WalkVelocity.ZERO);
    }

    @Override
    protected void see(Moment first, Moment now) {
        metres = first.place().ahead(now.place().point(0, 0, 0));
    }

    /** {@return whether the robot has got 5 m ahead on its feet} */
    @Override
    public boolean isDone() {
        return !hasFallen() && metres >= GOAL_METRES;
    }

    @Override
    public double value() {
        return metres - (hasFallen() ? FOR_A_FALL : 0);
    }
}
