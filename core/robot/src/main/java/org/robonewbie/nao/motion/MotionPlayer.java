package org.robonewbie.nao.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.IntStream;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.math.PortableMath;

/**
 * Plays one motion: calculates a speed for each joint and cycle from the keyframes. It needs no connection to a
 * simulator.
 *
 * <pre>{@code
 * MotionPlayer player = new MotionPlayer(motion, Interpolation.LINEAR);
 * while (!player.isFinished()) {
 *     // joints.sense(joint, degrees) for each joint of the new message
 *     player.step(motors);
 *     motors.endCycle();
 *     // send motors.sentDegreesPerSecond(joint) for each joint
 * }
 * }</pre>
 *
 * <p>In each cycle a joint is given the speed that moves it from its angle at the time the speed takes effect
 * ({@link Motors#expectedDegrees}) to the interpolated angle one cycle later. The trajectory passes through the
 * keyframes without stopping. Half of the tracking error is corrected in each cycle, and all of it in the last one.
 * Each keyframe takes a whole number of cycles of 20 ms, at least one; rounding errors do not accumulate. After the
 * last step the player stops all motors.
 */
public final class MotionPlayer {

    /** The property of a motion file that selects the playback rule. */
    public static final String RULE = "play";

    /** The value of {@link #RULE} for files made for RoboNewbie 1.1. */
    public static final String ORIGINAL = "1.1";

    private static final int CYCLE_MILLIS = 20;
    private static final double SMALLEST_TURN_DEGREES = 0.5;
    private static final Joint[] JOINTS = Joint.values();

    private final Motion motion;
    private final Interpolation interpolation;
    private final boolean isForNao;
    private final int[] keyframeEnds;
    private final Optional<OriginalRule> original;
    private Optional<PostureFollower> follower = Optional.empty();
    private List<KeyframeInterval> sections = List.of();
    private double fraction;
    private int cycle;
    private int keyframe;
    private boolean looping;

    /**
     * Creates a player at the start of a motion.
     *
     * @param motion the motion
     * @param interpolation the path of the joints of a NAO between keyframes; those of other robots turn at constant speed
     */
    public MotionPlayer(Motion motion, Interpolation interpolation) {
        this(motion, interpolation, Optional.empty());
    }

    private MotionPlayer(Motion motion, Interpolation interpolation, Optional<OriginalRule> original) {
        this.motion = motion;
        this.interpolation = interpolation;
        this.isForNao = motion.jointSpace().equals(JointSpace.NAO);
        this.keyframeEnds = keyframeEnds(motion);
        this.original = original;
    }

    /**
     * Creates a player for the motion in a file. A file with the comment {@code // play: 1.1} is played according to
     * the rule of RoboNewbie 1.1, and any other file with the given interpolation.
     *
     * @param file the file
     * @param speed speed factor; 1 plays as written, 2 twice as fast
     * @param interpolation the path of the joints of a NAO between keyframes; those of other robots turn at constant speed
     * @return the player
     */
    public static MotionPlayer of(MotionFile file, double speed, Interpolation interpolation) {
        Motion motion = speed == 1 ? file.motion() : file.motion().stretched(1 / speed);
        boolean old = file.property(RULE).filter(ORIGINAL::equals).isPresent();
        return new MotionPlayer(motion, interpolation, old ? Optional.of(new OriginalRule(motion)) : Optional.empty());
    }

    /** {@return the motion that this player plays} */
    public Motion motion() {
        return motion;
    }

    /**
     * {@return the zero-based index of the keyframe that the robot is approaching; after the end, the index of the last
     * one}
     */
    public int keyframe() {
        return original.map(OriginalRule::keyframe).orElse(keyframe);
    }

    /**
     * Returns whether the motion turns a joint on the way to the current keyframe. On the way to the first keyframe, every
     * joint that the motion turns later counts, because that movement depends on the robot's initial posture.
     *
     * @param joint the joint
     * @return whether a command for the joint would conflict with the motion
     */
    public boolean turns(Joint joint) {
        List<Keyframe> frames = motion.keyframes();
        int present = keyframe();
        return present == 0
                ? IntStream.range(1, frames.size()).anyMatch(index -> turns(joint, index))
                : turns(joint, present);
    }

    private boolean turns(Joint joint, int index) {
        Posture from = motion.keyframes().get(index - 1).posture();
        Posture to = motion.keyframes().get(index).posture();
        return Math.abs(to.degrees(joint) - from.degrees(joint)) > SMALLEST_TURN_DEGREES;
    }

    /** {@return the time since the motion began, or since its last repetition began, in seconds} */
    public double seconds() {
        return original.map(OriginalRule::cycles).orElse(cycle) * Cycle.SECONDS;
    }

    /**
     * Sets whether the motion repeats.
     *
     * @param looping whether the motion starts again after its last keyframe
     */
    public void setLooping(boolean looping) {
        this.looping = looping;
    }

    /** {@return whether the motion is finished: all its speeds have been set} */
    public boolean isFinished() {
        return original.isPresent()
                ? original.get().isFinished() && !looping
                : cycle >= lengthInCycles() && !(looping && lengthInCycles() > 0);
    }

    /**
     * Plays one cycle of 20 ms. After the end of the motion, stops the motors.
     *
     * @param motors the motors to read and to drive
     * @throws IllegalArgumentException if they are those of another robot than the motion's
     */
    public void step(Motors motors) {
        if (cycle == 0) {
            checkRobot(motors.joints().jointSpace());
        }
        if (isFinished()) {
            motors.stopMotion();
        } else if (original.isPresent()) {
            stepAsOriginal(original.get(), motors);
        } else {
            stepByPlan(motors);
        }
    }

    private static void stepAsOriginal(OriginalRule rule, Motors motors) {
        if (rule.isFinished()) {
            rule.begin();
        }
        rule.step(motors);
    }

    private void stepByPlan(Motors motors) {
        if (cycle == 0) {
            begin(motors);
        } else if (cycle == lengthInCycles()) {
            beginAgain();
        }
        cycle++;
        while (cycle > keyframeEnds[keyframe]) {
            keyframe++;
        }
        if (follower.isPresent()) {
            drive(follower.get());
        }
    }

    /**
     * Finds the joints and keyframes for which the motion exceeds the maximum speed of a motor.
     *
     * @param motors the motors, which determine the initial posture
     * @param fromKeyframe zero-based index of the first keyframe to check; 1 to skip keyframe 0, which the robot may take
     *     longer to reach
     * @return one sentence for each joint and keyframe that is too fast
     */
    public List<String> problems(Motors motors, int fromKeyframe) {
        List<String> problems = new ArrayList<>();
        List<JointSpace.Limits> limits = motion.jointSpace().joints();
        for (int i = fromKeyframe; i < keyframeEnds.length; i++) {
            KeyframeInterval section = new KeyframeInterval(motors.expectedPosture(), motion, i);
            double seconds = cyclesOf(i) * Cycle.SECONDS;
            for (int k = 0; k < limits.size(); k++) {
                double way = Math.abs(motors.inside(k, section.to().degrees(k))
                        - motors.inside(k, section.from().degrees(k)));
                if (motors.isFree(k) && way / seconds > limits.get(k).maxDegreesPerSecond() * 1.001) {
                    problems.add(tooFast(i, limits.get(k), way, seconds));
                }
            }
        }
        return problems;
    }

    private String tooFast(int index, JointSpace.Limits joint, double way, double seconds) {
        int enough = (int) Math.ceil(way / joint.maxDegreesPerSecond() * 1000 / CYCLE_MILLIS) * CYCLE_MILLIS;
        return String.format(
                Locale.ROOT,
                "Motion %s turns %s by %.0f degrees in %.0f ms on the way to keyframe %d, which is faster than its"
                        + " motor allows; plan at least %d ms.",
                motion.name(),
                joint.name(),
                way,
                seconds * 1000,
                index + 1,
                enough);
    }

    private void checkRobot(JointSpace robot) {
        JointSpace space = motion.jointSpace();
        if (!robot.equals(space)) {
            throw new IllegalArgumentException("Motion " + motion.name() + " is for the robot " + space.robot()
                    + ", but the motors are those of " + robot.robot() + ". Play a motion for that robot.");
        }
    }

    private void begin(Motors motors) {
        sections = sectionsFrom(motors.expectedPosture());
        follower = Optional.of(new PostureFollower(motors));
    }

    private void beginAgain() {
        Posture last = motion.keyframes().get(keyframe).posture();
        if (!sections.get(0).start().equals(last)) {
            sections = sectionsFrom(last);
        }
        cycle = 0;
        keyframe = 0;
    }

    private List<KeyframeInterval> sectionsFrom(Posture start) {
        return IntStream.range(0, keyframeEnds.length)
                .mapToObj(index -> new KeyframeInterval(start, motion, index))
                .toList();
    }

    private void drive(PostureFollower leader) {
        int before = keyframe == 0 ? 0 : keyframeEnds[keyframe - 1];
        fraction = (double) (cycle - before) / cyclesOf(keyframe);
        leader.follow(this::plannedDegrees, cycle == lengthInCycles() ? 1 : PostureFollower.CORRECTION);
    }

    private double plannedDegrees(int joint) {
        KeyframeInterval section = sections.get(keyframe);
        return isForNao
                ? interpolation.degrees(section, JOINTS[joint], fraction)
                : section.linearDegrees(joint, fraction);
    }

    private int cyclesOf(int index) {
        return keyframeEnds[index] - (index == 0 ? 0 : keyframeEnds[index - 1]);
    }

    private int lengthInCycles() {
        return keyframeEnds.length == 0 ? 0 : keyframeEnds[keyframeEnds.length - 1];
    }

    /**
     * Returns the cycle in which each keyframe is reached: the cycle nearest to the keyframe's time, but later than
     * that of the previous keyframe.
     */
    private static int[] keyframeEnds(Motion motion) {
        int[] ends = new int[motion.keyframes().size()];
        int millis = 0;
        int end = 0;
        for (int i = 0; i < ends.length; i++) {
            Keyframe frame = motion.keyframes().get(i);
            millis += Math.max(0, frame.durationMillis());
            end = Math.max(end + 1, (int) PortableMath.round((double) millis / CYCLE_MILLIS));
            ends[i] = end;
        }
        return ends;
    }
}
