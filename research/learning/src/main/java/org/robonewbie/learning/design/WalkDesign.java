package org.robonewbie.learning.design;

import java.util.List;
import org.robonewbie.agent.walk.Gait;
import org.robonewbie.agent.walk.Stance;
import org.robonewbie.learning.gait.Footsteps;
import org.robonewbie.learning.rehearsal.Rehearsal;
import org.robonewbie.learning.search.SearchPlan;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.file.ShippedMotions;

/**
 * A walk forward: the first step out of the stance, a cycle of two steps, and the stop that leads back to the stance. Searched
 * for are the gait and the length of its steps.
 */
public final class WalkDesign extends SearchedDesign {

    private static final String START = "start-walking";
    private static final String STOP = "stop-walking";
    private static final String STANCE = "stance";
    private static final String WALKING = "walking";
    private static final int STEP_LENGTH = Gait.PARAMETERS;
    private static final double METRES_PER_COORDINATE = 0.02;
    private static final double TRIAL_SECONDS = 5;
    private static final double PUSH_NEWTONS = 8;
    private static final int TAKING_UP_MILLIS = 160;
    private static final double FIRST_STEP = 0.65;
    private static final int STOP_MILLIS = 400;

    private final String name;
    private final boolean withStartAndStop;
    private final int stepMillis;
    private final int keyframesPerStep;
    private final double wantedSpeed;
    private final double armSwing;

    /**
     * Describes a walk.
     *
     * @param name name of the walk
     * @param withStartAndStop whether its first step and its stop are shipped as {@code start-walking} and {@code stop-walking}
     * @param stepMillis time of one step
     * @param keyframesPerStep postures in each step
     * @param wantedSpeed metres per second; more brings nothing
     * @param armSwing degrees of arm swing for each metre between the feet
     * @param start first guess: coordinates of {@link Gait#of} and the length of a step in units of 2 cm
     * @param plan how it is searched for
     */
    public WalkDesign(
            String name,
            boolean withStartAndStop,
            int stepMillis,
            int keyframesPerStep,
            double wantedSpeed,
            double armSwing,
            double[] start,
            SearchPlan plan) {
        super(start, plan);
        this.name = name;
        this.withStartAndStop = withStartAndStop;
        this.stepMillis = stepMillis;
        this.keyframesPerStep = keyframesPerStep;
        this.wantedSpeed = wantedSpeed;
        this.armSwing = armSwing;
    }

    @Override
    public List<DescribedMotion> motions(double[] x) {
        var walk = new DescribedMotion(
                walk(x), "two steps forward, left foot first; played again and again it is a walk", WALKING, WALKING);
        return withStartAndStop
                ? List.of(
                        new DescribedMotion(
                                start(x), "makes the first step of a walk, right foot first", STANCE, WALKING),
                        walk,
                        new DescribedMotion(stop(x), "sets the feet side by side after a walk", WALKING, STANCE))
                : List.of(walk);
    }

    @Override
    public double cost(double[] x, long seed) {
        try (Rehearsal robot = Rehearsal.inStance(seed, PUSH_NEWTONS)) {
            robot.play(withStartAndStop ? start(x) : ShippedMotions.motion(START));
            Motion walk = walk(x);
            while (robot.seconds() < TRIAL_SECONDS && robot.play(walk)) {
                // one cycle of two steps after the other
            }
            double seconds = robot.seconds();
            double speed = robot.forward() / seconds;
            boolean good = robot.play(withStartAndStop ? stop(x) : ShippedMotions.motion(STOP)) && robot.endsInStance();
            if (!good) {
                return 6 - 3 * seconds / TRIAL_SECONDS - Math.min(0.5, Math.max(0, speed));
            }
            return Costs.beyond(x, 6)
                    + 0.02 * Costs.degreesBeyondMotors(walk)
                    + 2 * Math.max(0, 1 - speed / wantedSpeed)
                    + 0.5 * Math.abs(robot.left())
                    + Math.abs(robot.turnedDegrees()) / 30
                    + Costs.roughness(robot.poise());
        }
    }

    private Gait gait(double[] x) {
        return Gait.of(stepMillis, keyframesPerStep, x).withArmSwing(armSwing);
    }

    private static double stepLength(double[] x) {
        return METRES_PER_COORDINATE * x[STEP_LENGTH];
    }

    private Motion start(double[] x) {
        Footsteps first = Footsteps.fromStance(gait(x), TAKING_UP_MILLIS)
                .step(Leg.RIGHT, Stance.RIGHT_FOOT.then(FIRST_STEP * stepLength(x), 0, 0));
        return new Motion(START, first.keyframes());
    }

    private Motion walk(double[] x) {
        double length = stepLength(x);
        Footsteps steps = walking(x)
                .step(Leg.LEFT, Stance.LEFT_FOOT.then(1.5 * length, 0, 0))
                .step(Leg.RIGHT, Stance.RIGHT_FOOT.then(2.5 * length, 0, 0));
        return new Motion(name, steps.keyframes());
    }

    private Motion stop(double[] x) {
        double half = stepLength(x) / 2;
        List<Keyframe> keyframes = walking(x)
                .step(Leg.LEFT, Stance.LEFT_FOOT.then(half, 0, 0), 0.9)
                .step(Leg.RIGHT, Stance.RIGHT_FOOT.then(half, 0, 0), 0.5)
                .end(STOP_MILLIS, Stance.POSTURE)
                .keyframes();
        return new Motion(STOP, keyframes);
    }

    /** In the middle of a walk the left foot is behind and about to swing. */
    private Footsteps walking(double[] x) {
        double half = stepLength(x) / 2;
        return new Footsteps(gait(x), Stance.LEFT_FOOT.then(-half, 0, 0), Stance.RIGHT_FOOT.then(half, 0, 0));
    }
}
