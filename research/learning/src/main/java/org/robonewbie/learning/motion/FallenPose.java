package org.robonewbie.learning.motion;

import java.util.Random;
import org.robonewbie.agent.walk.Stance;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Posture;

/** Pose of a robot lying on the ground, with trials that begin in this pose. */
public enum FallenPose {
    /** Chest up. */
    ON_BACK("lying on back"),
    /** Chest down. */
    ON_FRONT("lying on front"),
    /** Left side down. */
    ON_LEFT("lying on left side"),
    /** Right side down. */
    ON_RIGHT("lying on right side");

    private static final Vector3 FORWARD = new Vector3(1, 0, 0);
    private static final Vector3 LEFT = new Vector3(0, 1, 0);
    private static final double DOWN = 0.7;
    private static final double TILTED_DEGREES = 45;
    private static final double ARM_NOISE_DEGREES = 30;
    private static final double LEG_NOISE_DEGREES = 8;
    private static final int MAX_TRIES = 20;

    private final String words;

    FallenPose(String words) {
        this.words = words;
    }

    /** {@return the name of the pose in motion files, such as {@code lying on back}} */
    public String words() {
        return words;
    }

    /**
     * Returns whether a robot is in this pose.
     *
     * @param body the robot's body
     * @return whether it lies in this pose
     */
    public boolean isTrueOf(BodyState body) {
        double chestUp = body.torso().rotation().apply(FORWARD).z();
        double leftSideUp = body.torso().rotation().apply(LEFT).z();
        return switch (this) {
            case ON_BACK -> chestUp > DOWN;
            case ON_FRONT -> chestUp < -DOWN;
            case ON_LEFT -> leftSideUp < -DOWN;
            case ON_RIGHT -> leftSideUp > DOWN;
        };
    }

    /**
     * Pushes over robots with random postures, while their motors hold the joints, until one of them comes to rest in
     * this pose.
     *
     * @param type the robot type
     * @param seed the seed for the random postures and pushes
     * @return a trial of the robot in this pose
     * @throws IllegalStateException if no fall ends in this pose
     */
    public MotionTrial fallen(RobotType type, long seed) {
        Random random = new Random(31 * seed + ordinal());
        random.nextLong();
        for (int i = 0; i < MAX_TRIES; i++) {
            MotionTrial robot = fall(type, random);
            if (isTrueOf(robot.body())) {
                robot.begin(false);
                return robot;
            }
            robot.close();
        }
        throw new IllegalStateException("None of " + MAX_TRIES + " falls with seed " + seed + " ended " + words + ".");
    }

    private MotionTrial fall(RobotType type, Random random) {
        MotionTrial robot = MotionTrial.standing(type, WalkStyle.STANDARD);
        robot.moveTo(randomPosture(random), 700);
        Vector3 push = push(random);
        for (int tries = 0; robot.body().tiltDegrees() < TILTED_DEGREES && tries < 5; tries++) {
            robot.trial().with(trial -> trial.robot(0).push(push));
            robot.hold(0.16 + 0.04 * tries);
            robot.trial().with(trial -> {});
            robot.hold(1.6);
        }
        return robot;
    }

    private Vector3 push(Random random) {
        double strength = 30 + 20 * random.nextDouble();
        double aside = 8 * random.nextGaussian();
        return switch (this) {
            case ON_BACK -> new Vector3(-strength, aside, 0);
            case ON_FRONT -> new Vector3(strength, aside, 0);
            case ON_LEFT -> new Vector3(aside, strength, 0);
            case ON_RIGHT -> new Vector3(aside, -strength, 0);
        };
    }

    private static Posture randomPosture(Random random) {
        double[] degrees = Stance.POSTURE.toArray();
        for (Joint joint : Joint.values()) {
            boolean leg = joint.name().contains("HIP")
                    || joint.name().contains("KNEE")
                    || joint.name().contains("FOOT");
            degrees[joint.ordinal()] += random.nextGaussian() * (leg ? LEG_NOISE_DEGREES : ARM_NOISE_DEGREES);
        }
        return Posture.of(degrees).clamped();
    }
}
