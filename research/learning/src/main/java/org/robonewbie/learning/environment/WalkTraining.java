package org.robonewbie.learning.environment;

import java.util.List;
import java.util.Random;
import java.util.Set;
import org.robonewbie.learning.environment.DomainRandomization.Name;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.TrialHook;
import org.robonewbie.trial.WorldState;
import org.robonewbie.trial.measure.Pushes;

/**
 * Task: walk in a direction up to 30° beside the initial heading. PPO learns it from nothing: the observation is normalised, an action
 * lasts 40 ms and moves the joints a little, and each metre pays more than standing does in the time it takes.
 */
final class WalkTraining extends TrainingTask {

    /** The robot walks across the pitch, with 18 m ahead of it and neither ball nor goal in its way. */
    private static final Scene FREE_WAY =
            Scene.of(RobotStart.at(new Pose2d(0, -9, 90)).after(TO_THE_STANCE)).withBall(8, -8);

    private static final double MAX_DEGREES_ASIDE = 30;
    private static final double MAX_PUSH_NEWTONS = 8;
    private static final double MAX_HEADING_ERROR_DEGREES = 8;
    private static final int CYCLES_OF_AN_ERROR = 50;
    private static final double GOAL_METRES = 8;
    private static final double METRE_REWARD = 1;
    private static final double SECOND_REWARD = 0.1;
    private static final double FALL_PENALTY = 0.5;
    private static final ObservedQuantity HEADING = ObservedQuantity.symmetric("command.heading", "30 degrees", 6);
    private static final double HEADING_UNIT_DEGREES = 30;

    private double maxPaidMetresPerSecond = 0.6;
    private double degreesAside;
    private double headingErrorDegrees;
    private int cycles;
    private double degreesToTurn;
    private double metres;
    private double seconds;

    @Override
    void configure(DomainRandomization options) {
        rejectAllBut(options, Set.of(Name.SPEED));
        maxPaidMetresPerSecond = options.of(Name.SPEED, maxPaidMetresPerSecond);
    }

    @Override
    public int longestCycles() {
        return 1000;
    }

    @Override
    public int cyclesPerAction() {
        return 2;
    }

    @Override
    public Scene scene(RandomSource episodeRandom) {
        return FREE_WAY;
    }

    @Override
    public void begin(Trial trial) {
        degreesAside = random().between(-MAX_DEGREES_ASIDE, MAX_DEGREES_ASIDE);
    }

    @Override
    public double pushNewtons() {
        return MAX_PUSH_NEWTONS;
    }

    @Override
    TrialHook pushes(double newtons, long seed) {
        return Pushes.random(new Random(31 * seed + 7), newtons);
    }

    @Override
    public double actionLimit() {
        return 4.5;
    }

    @Override
    public double rangeDegrees() {
        return 30;
    }

    @Override
    public double rangeDegrees(Joint joint) {
        return switch (joint) {
            case LEFT_HIP_YAW_PITCH, RIGHT_HIP_YAW_PITCH -> 9;
            case LEFT_HIP_ROLL, RIGHT_HIP_ROLL, LEFT_FOOT_ROLL, RIGHT_FOOT_ROLL -> 15;
            default -> rangeDegrees();
        };
    }

    @Override
    public boolean observesGait() {
        return true;
    }

    @Override
    public List<ObservedQuantity> extraQuantities() {
        return List.of(HEADING);
    }

    /**
     * {@return the angle by which the robot has to turn left to face the direction, which an agent knows from its localisation: with an
     * error that jumps}
     */
    @Override
    public double[] extras() {
        return new double[] {degreesToTurn / HEADING_UNIT_DEGREES};
    }

    @Override
    protected void see(WorldState first, WorldState now) {
        Pose2d start = first.place();
        Pose2d towards = new Pose2d(start.x(), start.y(), start.degrees() + degreesAside);
        if (cycles % CYCLES_OF_AN_ERROR == 0) {
            headingErrorDegrees = random().between(-MAX_HEADING_ERROR_DEGREES, MAX_HEADING_ERROR_DEGREES);
        }
        cycles++;
        degreesToTurn = Angles.wrap(towards.degrees() - now.place().degrees() + headingErrorDegrees);
        if (!hasFallen()) {
            metres = towards.ahead(now.robot().position());
            seconds += Cycle.SECONDS;
        }
    }

    /** {@return whether the robot has walked 8 m without a fall} */
    @Override
    public boolean isDone() {
        return !hasFallen() && metres >= GOAL_METRES;
    }

    @Override
    public String rewardRule() {
        return "1 per metre in a direction up to 30 degrees beside the initial heading, up to 0.6 per second (option speed), and 0.1 per second; a fall costs 0.5."
                + " Each second a push of up to 8 N";
    }

    @Override
    public String successRule() {
        return "8 m in the direction without a fall";
    }

    @Override
    public double value() {
        double paid = Math.min(metres, maxPaidMetresPerSecond * seconds);
        return METRE_REWARD * paid + SECOND_REWARD * seconds - (hasFallen() ? FALL_PENALTY : 0);
    }
}
