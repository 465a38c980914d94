package org.robonewbie.studio.motion;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.MotionFormatException;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.nao.motion.file.ShippedMotions;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.studio.file.RefusedException;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;

/**
 * Result of playing a motion on a simulated body: the pose in every second cycle, and whether the robot fell.
 *
 * @param frames one array per pose: the torso's pose as seven numbers, then the angle of each hinge in degrees
 * @param fallSeconds time from the start of the motion to the first fall (torso tilted by more than 60° or near the
 *     ground); empty if the robot did not fall or did not start upright
 */
@SuppressWarnings("ArrayRecordComponent")
public record PhysicalTrial(List<float[]> frames, OptionalDouble fallSeconds) {

    /** Time between two frames in seconds; every second cycle yields a frame. */
    static final double FRAME_SECONDS = 2 * Cycle.SECONDS;

    private static final int POSE_NUMBERS = 7;
    private static final int MAX_MILLIS = 60_000;
    private static final int SETTLE_MILLIS = 400;
    private static final int LIE_MILLIS = 2000;
    private static final double LOOK_ON_SECONDS = 1;
    private static final Pose2d ALONG_THE_Y_AXIS = new Pose2d(0, 0, 90);
    private static final Vector3 BALL_ASIDE = new Vector3(-5, -3.5, 0);

    /** Initial posture. */
    public enum Start {
        /** Standing, with slightly bent knees. */
        STANDING,
        /** Lying on its back. */
        BACK,
        /** Lying on its front. */
        FRONT
    }

    /**
     * Plays a motion file.
     *
     * @param text contents of the file
     * @param start the name of a {@link Start} in lower case
     * @return the result as JSON
     * @throws RefusedException if the text is not a valid motion or is too long, or if the start is unknown
     */
    public static String json(String text, String start) {
        Start from = Arrays.stream(Start.values())
                .filter(each -> each.name().toLowerCase(Locale.ROOT).equals(start))
                .findFirst()
                .orElseThrow(() -> new RefusedException(
                        400, "Unknown start position \"" + start + "\". Choose standing, back or front."));
        try {
            return of(MotionFile.parse("motion.txt", text), from).json();
        } catch (MotionFormatException wrong) {
            throw new RefusedException(400, String.valueOf(wrong.getMessage()));
        }
    }

    private String json() {
        JsonObject json = new JsonObject();
        json.addProperty("frameSeconds", FRAME_SECONDS);
        fallSeconds.ifPresent(seconds -> json.addProperty("fallSeconds", seconds));
        JsonArray all = new JsonArray();
        for (float[] frame : frames) {
            JsonArray numbers = new JsonArray();
            for (float number : frame) {
                numbers.add(number);
            }
            all.add(numbers);
        }
        json.add("frames", all);
        return json.toString();
    }

    private static PhysicalTrial of(MotionFile file, Start start) {
        Motion motion = file.motion();
        if (motion.durationMillis() > MAX_MILLIS) {
            throw new RefusedException(
                    400, "The motion takes " + motion.durationMillis() / 1000 + " s. A trial can last at most 60 s.");
        }
        try (Controller player = Controller.ofMotion(file);
                Trial trial = Trial.direct(scene(start), 0, player)) {
            Watch watch = new Watch(trial.robot(0), start == Start.STANDING);
            watch.record();
            while (!player.isFinished()) {
                trial.step();
                watch.record();
            }
            double end = trial.seconds() + LOOK_ON_SECONDS;
            while (trial.seconds() < end) {
                trial.step();
                watch.record();
            }
            return new PhysicalTrial(watch.frames, watch.fall);
        }
    }

    private static Scene scene(Start start) {
        List<Motion> prelude = new ArrayList<>(thenStill(ShippedMotions.motion("stand"), SETTLE_MILLIS));
        if (start != Start.STANDING) {
            String fall = start == Start.BACK ? "fall-back" : "fall-forward";
            prelude.addAll(thenStill(ShippedMotions.motion(fall), LIE_MILLIS));
        }
        return Scene.of(RobotStart.at(ALONG_THE_Y_AXIS).after(prelude.toArray(Motion[]::new)))
                .withBall(BALL_ASIDE)
                .withoutNoise();
    }

    private static List<Motion> thenStill(Motion motion, int millis) {
        Posture last = motion.keyframes().get(motion.keyframes().size() - 1).posture();
        return List.of(motion, new Motion("still", List.of(new Keyframe(millis, last))));
    }

    /** Records poses and the first fall. */
    private static final class Watch {

        private final Robot robot;
        private final boolean standsAtFirst;
        private final List<float[]> frames = new ArrayList<>();
        private OptionalDouble fall = OptionalDouble.empty();
        private int cycles;

        private Watch(Robot robot, boolean standsAtFirst) {
            this.robot = robot;
            this.standsAtFirst = standsAtFirst;
        }

        private void record() {
            if (cycles % 2 == 0) {
                frames.add(frame(robot));
            }
            if (standsAtFirst && fall.isEmpty() && robot.isFallen()) {
                fall = OptionalDouble.of(cycles * Cycle.SECONDS);
            }
            cycles++;
        }
    }

    private static float[] frame(Robot robot) {
        BodyPose torso = robot.torso();
        Rotation rotation = torso.rotation().toQuaternion();
        float[] frame = new float[POSE_NUMBERS + robot.nao().hinges().size()];
        frame[0] = (float) torso.position().x();
        frame[1] = (float) torso.position().y();
        frame[2] = (float) torso.position().z();
        frame[3] = (float) rotation.w();
        frame[4] = (float) rotation.x();
        frame[5] = (float) rotation.y();
        frame[6] = (float) rotation.z();
        for (int i = POSE_NUMBERS; i < frame.length; i++) {
            frame[i] = (float) robot.jointDegrees(i - POSE_NUMBERS);
        }
        return frame;
    }
}
