package org.robonewbie.learning.optimise;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.robonewbie.agent.walk.Stance;
import org.robonewbie.learning.motion.FallenPose;
import org.robonewbie.learning.motion.MotionTrial;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.JointSpace;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.nao.motion.file.ShippedMotions;
import org.robonewbie.trial.Measure;
import org.robonewbie.trial.measure.BalanceMetrics;
import org.robonewbie.trial.measure.KickDistance;

/**
 * Trial of a motion, as defined by the properties in its file: {@code // start: stance} or
 * {@code // start: lying on back} is the initial pose, {@code // end: stance} or {@code // end: lying on front} the
 * required final pose, {@code // ball: 0.190 m ahead, -0.055 m to the left} the position of the ball. A motion that
 * starts and ends in {@code walking} is played in a loop. By default, the robot starts in its standard stance and must
 * not fall.
 */
final class MotionScene {

    private static final Pose2d BEFORE_GOAL = new Pose2d(1, 0, 0);
    private static final double PUSH_NEWTONS = 3;
    private static final double WALK_SECONDS = 8;
    private static final double SETTLING_SECONDS = 1;
    private static final double ROLLING_SECONDS = 4;

    private final Objective objective;
    private final Optional<Translation2d> ball;
    private final Optional<FallenPose> lyingStart;
    private final Optional<FallenPose> lyingEnd;
    private final boolean loop;
    private final boolean endsInStance;
    private final Motion motion;
    private final boolean keepsEffect;

    MotionScene(MotionFile file, Objective objective) {
        this.objective = objective;
        this.motion = file.motion();
        String start = file.property("start").orElse("stance");
        String end = file.property("end").orElse("");
        this.ball = file.ball();
        this.lyingStart = lying(start);
        this.lyingEnd = lying(end);
        this.loop = start.contains("walking") && end.contains("walking");
        this.endsInStance = end.equals("stance") || loop || (end.isEmpty() && endsWithStance(motion));
        this.keepsEffect = objective.rewardsInaction();
        if (objective.needsBall() && ball.isEmpty()) {
            throw new IllegalArgumentException(
                    file.name() + " does not define the position of the ball, so " + objective.label()
                            + " cannot be measured. Add a line such as: // ball: 0.190 m ahead, -0.055 m to the left");
        }
    }

    Evaluation evaluate(Motion candidate, long seed) {
        Result result = play(candidate, seed);
        double flaws = result.flaws + 0.01 * Math.max(0, beyondMotors(candidate) - beyondMotors(motion));
        if (keepsEffect) {
            flaws += result.effect.difference(play(motion, seed).effect);
        }
        return new Evaluation(result.value, result.success ? 1 : 0, flaws);
    }

    private Result play(Motion candidate, long seed) {
        try (MotionTrial robot = start(seed)) {
            ball.ifPresent(place -> robot.placeBall(place, seed));
            Measure measure = objective.measure().get();
            KickDistance kick = new KickDistance();
            robot.watch(measure);
            robot.watch(kick);
            if (lyingEnd.isPresent()) {
                robot.allowFalls();
            }
            perform(candidate, robot);
            double value = measure.value();
            MotionEffect effect = effect(robot, kick);
            if (loop) {
                robot.play(ShippedMotions.motion("stop-walking"));
            }
            robot.hold(objective.isTimeToScore() ? ROLLING_SECONDS : SETTLING_SECONDS);
            if (!loop) {
                value = measure.value();
                effect = effect(robot, kick);
            }
            return new Result(value, isSuccess(robot), roughness(robot.balance()), effect);
        }
    }

    private boolean isSuccess(MotionTrial robot) {
        if (lyingEnd.isPresent()) {
            return lyingEnd.get().isTrueOf(robot.body());
        }
        if (endsInStance) {
            return robot.isInStance();
        }
        return lyingStart.isPresent() ? robot.isAtRest() : !robot.balance().hasFallen();
    }

    private static MotionEffect effect(MotionTrial robot, KickDistance kick) {
        return new MotionEffect(robot.forward(), robot.left(), robot.turnedDegrees(), kick.value());
    }

    private MotionTrial start(long seed) {
        if (lyingStart.isPresent()) {
            return lyingStart.get().fallen(RobotType.TYPE_0, seed);
        }
        return objective.isTimeToScore()
                ? MotionTrial.inStance(BEFORE_GOAL, seed, PUSH_NEWTONS)
                : MotionTrial.inStance(seed, PUSH_NEWTONS);
    }

    private void perform(Motion candidate, MotionTrial robot) {
        if (!loop) {
            robot.play(candidate);
            return;
        }
        robot.play(ShippedMotions.motion("start-walking"));
        while (robot.seconds() < WALK_SECONDS && robot.play(candidate)) {
            // The loop ends with the first fall.
        }
    }

    /** Returns the penalty for a swaying torso and for joints at their limits, regardless of the objective. */
    private static double roughness(BalanceMetrics balance) {
        return 0.001 * balance.value() + 0.03 * balance.meanJointsAtLimit();
    }

    /**
     * Returns how far a looped motion exceeds the speed limits of the motors: the sum, over all keyframes and joints, of
     * the degrees that a motor cannot cover in time.
     */
    private static double beyondMotors(Motion motion) {
        double sum = 0;
        List<JointSpace.Limits> joints = motion.jointSpace().joints();
        List<Keyframe> keyframes = motion.keyframes();
        Posture before = keyframes.get(keyframes.size() - 1).posture();
        for (Keyframe keyframe : keyframes) {
            double seconds = keyframe.durationMillis() / 1000.0;
            for (int i = 0; i < joints.size(); i++) {
                double change = Math.abs(keyframe.posture().degrees(i) - before.degrees(i));
                sum += Math.max(0, change - joints.get(i).maxDegreesPerSecond() * seconds);
            }
            before = keyframe.posture();
        }
        return sum;
    }

    private static Optional<FallenPose> lying(String words) {
        return Arrays.stream(FallenPose.values())
                .filter(lying -> words.contains(lying.words()))
                .findFirst();
    }

    private static boolean endsWithStance(Motion motion) {
        Keyframe last = motion.keyframes().get(motion.keyframes().size() - 1);
        return last.posture().equals(Stance.POSTURE);
    }

    private record Result(double value, boolean success, double flaws, MotionEffect effect) {}
}
