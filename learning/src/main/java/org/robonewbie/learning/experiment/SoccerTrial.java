package org.robonewbie.learning.experiment;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.world.SoccerWorld;

/**
 * A trial in the world of the simulator: the same bodies, motors, perceptors, delay and noise as with a server, but no
 * messages, no referee and no clock.
 */
public final class SoccerTrial implements Trial {

    private static final int CYCLES_PER_PICTURE = 3;
    private static final double STEPS_TO_REST = 0.6;

    private final TrialSetting setting;
    private final List<ObservedQuantity> quantities;
    private final List<TrialRobotBody> bodies = new ArrayList<>();
    private SoccerWorld world;
    private long cycles;

    /**
     * Creates a trial that has begun with seed 0.
     *
     * @param setting how it begins
     */
    public SoccerTrial(TrialSetting setting) {
        this.setting = setting;
        this.quantities = Perception.quantities(setting.camera());
        this.world = new SoccerWorld(setting.field());
        begin(0);
    }

    @Override
    public void reset(long seed) {
        world = new SoccerWorld(setting.field());
        begin(seed);
    }

    private void begin(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        bodies.clear();
        for (RobotStart start : setting.robots()) {
            bodies.add(new TrialRobotBody(world, setting, start, random.split()));
        }
        world.ball().place(setting.ball().plus(spread(random, 1)).plus(spread(random, 0)));
        long settling = Math.round(setting.settlingSeconds() / Cycle.SECONDS);
        for (long i = 0; i < settling; i++) {
            double progress = Math.min(1, i / (STEPS_TO_REST * settling));
            bodies.forEach(body -> body.settle(progress));
            advance();
        }
        cycles = 0;
        bodies.forEach(TrialRobotBody::begin);
    }

    private Vector3 spread(SplittableRandom random, int alongX) {
        double metres = setting.placeSpreadMetres() * (2 * random.nextDouble() - 1);
        return new Vector3(alongX * metres, (1 - alongX) * metres, 0);
    }

    @Override
    public void step(double[]... degreesPerSecond) {
        check(degreesPerSecond);
        for (int i = 0; i < bodies.size(); i++) {
            bodies.get(i).command(degreesPerSecond[i]);
        }
        advance();
    }

    private void advance() {
        world.step();
        cycles++;
        for (TrialRobotBody body : bodies) {
            body.sense(cycles % CYCLES_PER_PICTURE == 0);
        }
    }

    private void check(double[][] degreesPerSecond) {
        if (degreesPerSecond.length != bodies.size()) {
            throw new IllegalArgumentException("Commands for " + degreesPerSecond.length + " robots, but the trial has "
                    + bodies.size() + ". Give step() one array for each robot.");
        }
        for (int i = 0; i < degreesPerSecond.length; i++) {
            check(degreesPerSecond[i], i);
        }
    }

    private static void check(double[] speeds, int robot) {
        if (speeds.length != Joint.COUNT) {
            throw new IllegalArgumentException(
                    "Robot " + robot + " gets " + speeds.length + " joint speeds, but it has " + Joint.COUNT
                            + " joints. Give one speed for each Joint in its order.");
        }
        for (Joint joint : Joint.values()) {
            if (Double.isNaN(speeds[joint.ordinal()])) {
                throw new IllegalArgumentException(
                        "Joint speed NaN for " + joint + " of robot " + robot + ". Was something divided by zero?");
            }
        }
    }

    @Override
    public int robots() {
        return bodies.size();
    }

    @Override
    public WorldState state() {
        return new WorldState(
                cycles * Cycle.SECONDS,
                bodies.stream().map(TrialRobotBody::state).toList(),
                world.ball().position(),
                world.ball().velocity());
    }

    @Override
    public List<ObservedQuantity> quantities() {
        return quantities;
    }

    @Override
    public double[] observation(int robot) {
        return bodies.get(robot).observation();
    }

    /** {@return the world of this trial until the next reset, to push robots or to move the ball in the middle of a trial} */
    public SoccerWorld world() {
        return world;
    }
}
