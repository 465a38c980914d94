package org.robonewbie.exercises.solution;

import java.util.List;
import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;

/** Looks before which foot the ball lies, shifts the weight onto the other, swings back, and through the ball. */
public final class Kick extends Agent {

    private static final Posture STANCE = legs(Posture.ZERO, "LEFT", 0, 35, -70, 37, 0);
    private static final Posture WEIGHT = support(24);

    private static final Motion KICK = new Motion(
            "my-kick",
            List.of(
                    new Keyframe(500, legs(WEIGHT, "LEFT", 24, 20, -60, 42, -18)),
                    new Keyframe(240, legs(WEIGHT, "LEFT", 20, 40, -105, 50, 0)),
                    new Keyframe(80, legs(WEIGHT, "LEFT", 16, 30, -118, 68, 0)),
                    new Keyframe(140, legs(WEIGHT, "LEFT", 20, 77, -70, 22, 0)),
                    new Keyframe(240, legs(WEIGHT, "LEFT", 20, 45, -95, 45, 0)),
                    new Keyframe(300, legs(WEIGHT, "LEFT", 24, 20, -60, 42, -18)),
                    new Keyframe(500, legs(STANCE, "RIGHT", 0, 35, -70, 37, 0))));

    private boolean kicked;

    /** Creates the solution. */
    public Kick() {}

    @Override
    protected void think() {
        if (!kicked) {
            nao.setJointAngle(Joint.NECK_PITCH, -30, 90);
            if (fieldView.ball().isVisible()) {
                kicked = motions.start(fieldView.ball().bearing() > 0 ? KICK : KICK.mirrored());
            }
        }
    }

    /** Stands on the right leg, so far over its foot. */
    private static Posture support(double rollDegrees) {
        return legs(Posture.ZERO, "RIGHT", rollDegrees, 17, -49, 37, -rollDegrees + 4);
    }

    private static Posture legs(
            Posture posture, String side, double hipRoll, double hip, double knee, double ankle, double ankleRoll) {
        return posture.with(Joint.valueOf(side + "_HIP_ROLL"), hipRoll)
                .with(Joint.valueOf(side + "_HIP_PITCH"), hip)
                .with(Joint.valueOf(side + "_KNEE_PITCH"), knee)
                .with(Joint.valueOf(side + "_FOOT_PITCH"), ankle)
                .with(Joint.valueOf(side + "_FOOT_ROLL"), ankleRoll)
                .with(Joint.LEFT_SHOULDER_PITCH, -90)
                .with(Joint.RIGHT_SHOULDER_PITCH, -90)
                .with(Joint.LEFT_SHOULDER_YAW, 20)
                .with(Joint.RIGHT_SHOULDER_YAW, -20);
    }
}
