package org.robonewbie.examples;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.Options;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;

/**
 * A robot that dances instead of playing soccer. The program creates the motion instead of reading it from a file: a sequence
 * of postures, each with the time in which to reach it.
 *
 * <p>Create your own dance: which joints can the robot move without falling, and how fast?
 */
public final class Agent_Dance extends Agent {

    private static final Posture STANCE = legs(Posture.ZERO, 35, -70, 37);
    private static final Posture KNEES_BENT = legs(Posture.ZERO, 50, -100, 52);
    private static final int BEAT_MILLIS = 480;

    /** Creates the agent. */
    public Agent_Dance() {}

    /**
     * Starts the robot.
     *
     * @param args options such as {@code --headless}; {@code --help} lists them
     */
    public static void main(String[] args) {
        new Agent_Dance().run(args);
    }

    @Override
    protected Options defaults() {
        return Options.none().withPose(-1, 0, 0);
    }

    @Override
    protected void think() {
        if (motions.isFinished()) {
            if (nao.isFallen()) {
                motions.startGetUp();
            } else {
                motions.start(dance());
            }
        }
    }

    private static Motion dance() {
        List<Keyframe> beats = new ArrayList<>();
        beats.add(beat(STANCE, 0, 0, 0));
        for (int i = 0; i < 2; i++) {
            beats.add(beat(KNEES_BENT, 60, -60, 30));
            beats.add(beat(STANCE, 60, -60, 0));
            beats.add(beat(KNEES_BENT, -60, 60, -30));
            beats.add(beat(STANCE, -60, 60, 0));
        }
        beats.add(beat(STANCE, 90, 90, 0));
        beats.add(beat(KNEES_BENT, -60, -60, 0));
        return new Motion("dance", beats);
    }

    private static Keyframe beat(Posture legs, double leftArm, double rightArm, double head) {
        Posture posture = legs.with(Joint.LEFT_SHOULDER_PITCH, leftArm)
                .with(Joint.RIGHT_SHOULDER_PITCH, rightArm)
                .with(Joint.LEFT_SHOULDER_YAW, 30)
                .with(Joint.RIGHT_SHOULDER_YAW, -30)
                .with(Joint.NECK_YAW, head);
        return new Keyframe(BEAT_MILLIS, posture);
    }

    private static Posture legs(Posture posture, double hip, double knee, double foot) {
        return posture.with(Joint.LEFT_HIP_PITCH, hip)
                .with(Joint.RIGHT_HIP_PITCH, hip)
                .with(Joint.LEFT_KNEE_PITCH, knee)
                .with(Joint.RIGHT_KNEE_PITCH, knee)
                .with(Joint.LEFT_FOOT_PITCH, foot)
                .with(Joint.RIGHT_FOOT_PITCH, foot);
    }
}
