package org.robonewbie.learning.environment;

import java.util.Optional;
import java.util.Random;
import java.util.function.Function;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.walk.ResidualPolicy;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.learning.environment.DomainRandomization.Name;
import org.robonewbie.learning.environment.DomainRandomization.Range;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.perceptor.FootForces;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.TrialHook;
import org.robonewbie.trial.WorldState;
import org.robonewbie.trial.measure.Pushes;

/** Task: follow velocities with a learned gait and learned corrections to the output of the walk engine. */
final class GaitTraining extends CommandedTraining {

    private static final double BACKWARD = 0.3;
    private static final int CYCLE_MILLIS = 20;
    private static final int WINDOW = 20;
    private static final int CYCLES_TO_SETTLE = 60;
    private static final double TOLERATED_DEGREES_PER_SECOND = 30;
    private static final double FALL_PENALTY = 4;
    private static final double LEAN_PENALTY = 0.002;
    private static final double MAX_PUSH_NEWTONS = 6;

    private final Function<GaitTraining, WalkVelocity> commands;
    private final double restLeanPenalty;
    private final double maxDeceleration;
    private WalkVelocity max;
    private double minShare;
    private int stepMillis;
    private double slowShare;
    private double toleratedMetresPerSecond;
    private double constantShare = 0.4;
    private double flightCost;
    private int cyclesOfEpisode;
    private Range types = new Range(0, 0);
    private Optional<Policy> policy = Optional.empty();

    private Random draws = new Random(0);
    private boolean isConstant;
    private boolean hasBegun;
    private WalkVelocity command = WalkVelocity.ZERO;
    private WalkVelocity followed = WalkVelocity.ZERO;
    private Optional<Pose2d> before = Optional.empty();
    private double totalReward;
    private double fallCost;
    private VelocityError settledError = VelocityError.NONE;

    private GaitTraining(
            Function<GaitTraining, WalkVelocity> commands,
            WalkVelocity max,
            double minShare,
            int stepMillis,
            double slowShare,
            double toleratedMetresPerSecond,
            double restLeanPenalty,
            double maxDeceleration) {
        this.commands = commands;
        this.max = max;
        this.minShare = minShare;
        this.stepMillis = stepMillis;
        this.slowShare = slowShare;
        this.toleratedMetresPerSecond = toleratedMetresPerSecond;
        this.restLeanPenalty = restLeanPenalty;
        this.maxDeceleration = maxDeceleration;
    }

    /** Creates the task of walking in any direction, forward at up to 0.8 m/s. */
    static GaitTraining walking() {
        WalkVelocity max = new WalkVelocity(0.8, 0.2, 90);
        return new GaitTraining(
                GaitTraining::drawAnyDirection, max, 0.3, 200, 0, 0.3, LEAN_PENALTY, Double.POSITIVE_INFINITY);
    }

    /**
     * Creates the task of jogging forward at 0.66 to 1.1 m/s, straight or in curves, sometimes slowing down or stopping.
     * Turning reduces the speed only slightly.
     */
    static GaitTraining jogging() {
        WalkVelocity max = new WalkVelocity(1.1, 0.2, 300);
        return new GaitTraining(GaitTraining::drawCurve, max, 0.6, 140, 0.3, 0.5, 0.1, Double.POSITIVE_INFINITY);
    }

    /**
     * Creates the task of running forward at 0.9 to 1.3 m/s in slight curves, sometimes slowing down or stopping with
     * limited deceleration.
     */
    static GaitTraining running() {
        WalkVelocity max = new WalkVelocity(1.3, 0.2, 60);
        return new GaitTraining(GaitTraining::drawSlightCurve, max, 0.7, 140, 0.3, 0.9, LEAN_PENALTY, 0.6);
    }

    @Override
    void configure(DomainRandomization options) {
        options.range(Name.SPEED).ifPresent(speed -> {
            max = new WalkVelocity(speed.high(), max.left(), max.turn());
            minShare = speed.low() / speed.high();
        });
        stepMillis = (int) options.of(Name.STEP, stepMillis);
        if (stepMillis % CYCLE_MILLIS != 0) {
            throw new IllegalArgumentException("The option step=" + stepMillis + " is not a multiple of 20.");
        }
        slowShare = options.of(Name.SLOW, slowShare);
        toleratedMetresPerSecond = options.of(Name.TOLERANCE, toleratedMetresPerSecond);
        constantShare = options.of(Name.CONSTANT, constantShare);
        flightCost = options.of(Name.FLIGHT, flightCost);
        cyclesOfEpisode = options.longestCycles(this);
        types = options.range(Name.TYPE).orElse(types);
    }

    @Override
    void setPolicy(Policy learned) {
        policy = Optional.of(learned);
    }

    @Override
    public Optional<Policy> walk() {
        return policy.or(() -> Optional.of(WalkGuide.engine(stepMillis, max, BACKWARD)));
    }

    @Override
    public double rangeDegrees() {
        return ResidualPolicy.RANGE_DEGREES;
    }

    @Override
    public boolean learnsGait() {
        return true;
    }

    @Override
    public int longestCycles() {
        return 450;
    }

    @Override
    public Scene scene(RandomSource random) {
        int count = (int) (types.high() - types.low()) + 1;
        int type = (int) types.low() + (int) Math.floorMod(random.seed(), (long) count);
        return Scene.of(RobotStart.at(0, 0).withType(RobotType.values()[type]).after(TO_THE_STANCE))
                .withParameters(SoccerParameters.league())
                .withBall(0, -9);
    }

    @Override
    public void begin(Trial trial) {
        draws = new Random(31 * random().seed() + 7);
        draws.nextLong();
        isConstant = draws.nextDouble() < constantShare;
        super.begin(trial);
        command = super.velocity();
    }

    @Override
    public double pushNewtons() {
        return MAX_PUSH_NEWTONS;
    }

    @Override
    TrialHook pushes(double newtons, long seed) {
        return Pushes.random(draws, newtons);
    }

    @Override
    WalkVelocity draw(RandomSource random, WalkVelocity previous) {
        if (!hasBegun) {
            hasBegun = true;
            return isConstant && draws.nextDouble() < 0.5
                    ? new WalkVelocity(max.forward(), 0, 0)
                    : commands.apply(this);
        }
        return isConstant ? previous : drawNext();
    }

    /** Draws the next command: a stop, a slow velocity, or one from the distribution of the first command. */
    private WalkVelocity drawNext() {
        double slow = slowShare > 0 ? draws.nextDouble() : 1;
        if (slow < slowShare / 2) {
            return WalkVelocity.ZERO;
        }
        return slow < slowShare
                ? new WalkVelocity(max.forward() * minShare * draws.nextDouble(), 0, 0)
                : commands.apply(this);
    }

    /** Picks a random velocity: forward, backward, sideways, turning in place, zero, or a combination within the limits. */
    private WalkVelocity drawAnyDirection() {
        double kind = draws.nextDouble();
        double forward = draws.nextDouble();
        double left = max.left() * (2 * draws.nextDouble() - 1);
        double turn = max.turn() * (2 * draws.nextDouble() - 1);
        if (kind < 0.35) {
            return new WalkVelocity(forward(forward), 0, 0);
        } else if (kind < 0.5) {
            return new WalkVelocity(-BACKWARD * forward, 0, 0);
        } else if (kind < 0.62) {
            return new WalkVelocity(0, left, 0);
        } else if (kind < 0.74) {
            return new WalkVelocity(0, 0, turn);
        } else if (kind < 0.78) {
            return WalkVelocity.ZERO;
        }
        double any = -BACKWARD + (max.forward() + BACKWARD) * forward;
        return new WalkVelocity(any, left, turn).within(max, BACKWARD);
    }

    /** Draws a forward velocity, straight in half of the cases. */
    private WalkVelocity drawCurve() {
        double forward = forward(draws.nextDouble());
        double kind = draws.nextDouble();
        double turn = 2 * draws.nextDouble() - 1;
        return new WalkVelocity(forward, 0, kind < 0.5 ? 0 : turn * (kind < 0.8 ? 15 : 45));
    }

    /** Draws a forward velocity, straight in three of five cases. */
    private WalkVelocity drawSlightCurve() {
        double forward = forward(draws.nextDouble());
        double turn = 20 * (2 * draws.nextDouble() - 1);
        return new WalkVelocity(forward, 0, draws.nextDouble() < 0.6 ? 0 : turn);
    }

    private double forward(double share) {
        return max.forward() * (minShare + (1 - minShare) * share);
    }

    @Override
    public void act(Trial trial) {
        followed = command;
        super.act(trial);
        WalkVelocity wanted = super.velocity();
        double min = command.forward() - maxDeceleration * Cycle.SECONDS;
        command = wanted.forward() >= min ? wanted : new WalkVelocity(min, wanted.left(), wanted.turn());
    }

    @Override
    protected WalkVelocity velocity() {
        return command;
    }

    @Override
    void feel(FootForces feet) {
        if (!hasFallen() && feet.left().isEmpty() && feet.right().isEmpty()) {
            totalReward -= flightCost * Cycle.SECONDS;
        }
    }

    @Override
    protected void see(WorldState first, WorldState now) {
        if (hasFallen()) {
            fallCost = fallCost > 0 ? fallCost : FALL_PENALTY + (cyclesOfEpisode - cycle() + 1) / (double) WINDOW;
        } else if (cycle() % WINDOW == 0) {
            endWindow(now);
        }
    }

    private void endWindow(WorldState now) {
        before.ifPresent(place -> addWindow(
                VelocityError.between(place, now.place(), WINDOW * Cycle.SECONDS, followed),
                now.robot().tiltDegrees()));
        before = Optional.of(now.place());
    }

    private void addWindow(VelocityError error, double tiltDegrees) {
        boolean settled = (cycle() - 1) % CYCLES_PER_COMMAND >= CYCLES_TO_SETTLE + WINDOW - 1;
        double leanPenalty = settled && followed.isZero() ? restLeanPenalty : LEAN_PENALTY;
        totalReward +=
                1 - error.cost(toleratedMetresPerSecond, TOLERATED_DEGREES_PER_SECOND) - leanPenalty * tiltDegrees;
        if (settled) {
            settledError = settledError.plus(error);
        }
    }

    @Override
    public VelocityError velocityError() {
        return settledError;
    }

    @Override
    public String rewardRule() {
        return "1 per 0.4 s, minus the velocity error (1 for the tolerance or 30 degrees/s, at most 1.5) and a "
                + "little for a leaning torso; a fall costs 4, plus 1 for each 0.4 s left. A new command every 3 "
                + "s, a push every second";
    }

    @Override
    public double value() {
        return totalReward - fallCost;
    }
}
