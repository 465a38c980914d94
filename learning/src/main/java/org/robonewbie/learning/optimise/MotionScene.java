package org.robonewbie.learning.optimise;

import java.util.Arrays;
import java.util.Optional;
import java.util.Random;
import org.robonewbie.agent.walk.Stance;
import org.robonewbie.learning.design.Costs;
import org.robonewbie.learning.trial.Course;
import org.robonewbie.learning.trial.Lying;
import org.robonewbie.learning.trial.TrialObserver;
import org.robonewbie.learning.trial.TrialRobot;
import org.robonewbie.learning.trial.Watch;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.motion.BallPlace;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.file.ShippedMotions;

/**
 * How a motion is tried, from what its file says: {@code // start: stance} or {@code // start: lying on back} is how the robot
 * begins, {@code // end: stance} or {@code // end: lying on front} how it has to end, {@code // ball: 0.190 m ahead, -0.055 m to
 * the left} where the ball lies, and a motion that begins and ends in {@code walking} is played again and again. Nothing said
 * means: it begins in the stance and ends on its feet.
 */
final class MotionScene {

    private static final double BALL_RADIUS = 0.042;
    private static final double PUSH_NEWTONS = 3;
    private static final double WALK_SECONDS = 8;
    private static final double SETTLING_SECONDS = 1;
    private static final double METRES_BEFORE_GOAL = 5;
    private static final double GOAL_LINE = 6;
    private static final double SECONDS_TO_ROLL = 4;

    private final Objective objective;
    private final Optional<BallPlace> ball;
    private final Optional<Lying> lyingStart;
    private final Optional<Lying> lyingEnd;
    private final boolean loop;
    private final boolean endsInStance;
    private final Motion motion;
    private final boolean keepsDeed;

    MotionScene(MotionFile file, Objective objective) {
        this.objective = objective;
        this.motion = file.motion();
        String start = file.property("start").orElse("stance");
        String end = file.property("end").orElse("");
        this.ball = file.ball();
        this.lyingStart = lying(start);
        this.lyingEnd = lying(end);
        this.loop = start.contains("walking") && end.contains("walking");
        this.endsInStance = end.equals("stance") || loop || (end.isEmpty() && lastPosture(motion));
        this.keepsDeed = objective.temptsToDoLess();
        if (objective.needsBall() && ball.isEmpty()) {
            throw new IllegalArgumentException(
                    file.name() + " does not say where the ball lies, so " + objective.label()
                            + " cannot be measured. Add a line such as: // ball: 0.190 m ahead, -0.055 m to the left");
        }
    }

    /** Tries a motion. */
    Attempt attempt(Motion candidate, long seed) {
        Seen seen = play(candidate, seed);
        double flaws = seen.flaws + 0.01 * Math.max(0, beyondMotors(candidate) - beyondMotors(motion));
        if (keepsDeed) {
            flaws += seen.deed.difference(play(motion, seed).deed);
        }
        return new Attempt(seen.value, seen.success ? 1 : 0, flaws);
    }

    private Seen play(Motion candidate, long seed) {
        return lyingStart.isPresent() ? fromTheGround(candidate, lyingStart.get(), seed) : onFoot(candidate, seed);
    }

    private Seen onFoot(Motion candidate, long seed) {
        MeasuringEye eye = new MeasuringEye(objective.measure().get());
        Course course = new Course(start(), seed, PUSH_NEWTONS, eye);
        place(course, seed);
        if (loop) {
            course.play(ShippedMotions.motion("start-walking"));
            while (course.watch().seconds() < WALK_SECONDS && course.play(candidate)) {
                // one cycle after the other
            }
            eye.close();
            course.play(ShippedMotions.motion("stop-walking"));
        } else {
            course.play(candidate);
        }
        boolean stands = course.endsInStance();
        if (objective.isTimeToScore()) {
            course.robot().hold(SECONDS_TO_ROLL, eye);
        }
        boolean success = lyingEnd.isPresent()
                ? lyingEnd.get().isTrueOf(course.robot())
                : endsInStance ? stands : !course.watch().hasFallen();
        return new Seen(eye.value(), success, roughness(course.watch()), eye.deed());
    }

    private Seen fromTheGround(Motion candidate, Lying lying, long seed) {
        MeasuringEye eye = new MeasuringEye(objective.measure().get());
        Watch watch = new Watch();
        TrialObserver both = eye.and(robot -> {
            watch.goOn(robot);
            return true;
        });
        TrialRobot robot = lying.fallen(seed);
        robot.play(candidate, both);
        robot.hold(SETTLING_SECONDS, both);
        boolean success = lyingEnd.isPresent() ? lyingEnd.get().isTrueOf(robot) : stands(robot);
        return new Seen(eye.value(), success, roughness(watch), eye.deed());
    }

    private void place(Course course, long seed) {
        if (ball.isPresent()) {
            Random random = new Random(7 * seed + 3);
            random.nextLong();
            BallPlace near = ball.get().near(random);
            course.robot().ball().place(course.place(near.ahead(), near.left(), BALL_RADIUS));
        }
    }

    private Vector3 start() {
        return objective.isTimeToScore()
                ? new Vector3(GOAL_LINE - METRES_BEFORE_GOAL, 0, TrialRobot.START.z())
                : TrialRobot.START;
    }

    private boolean stands(TrialRobot robot) {
        return robot.uprightness() > 0.97
                && robot.velocity().length() < 0.05
                && (!endsInStance || robot.posture().largestDifference(Stance.POSTURE) < 3);
    }

    /** A calm torso and motors within their limits are worth something whatever the objective is. */
    private static double roughness(Watch watch) {
        return 0.001 * watch.meanRocking() + 0.03 * watch.meanJointsAtLimit();
    }

    private static double beyondMotors(Motion motion) {
        return Costs.degreesBeyondMotors(motion);
    }

    private static Optional<Lying> lying(String words) {
        return Arrays.stream(Lying.values())
                .filter(lying -> words.contains(lying.words()))
                .findFirst();
    }

    private static boolean lastPosture(Motion motion) {
        Keyframe last = motion.keyframes().get(motion.keyframes().size() - 1);
        return last.posture().equals(Stance.POSTURE);
    }

    /** What one trial showed. */
    private record Seen(double value, boolean success, double flaws, Deed deed) {}
}
