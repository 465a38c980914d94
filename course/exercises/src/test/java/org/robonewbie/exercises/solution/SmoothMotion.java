package org.robonewbie.exercises.solution;

import java.util.List;
import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.KeyframeInterval;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;

/** Cubic curves: the slope at a keyframe is that from the keyframe before to the one after. */
public final class SmoothMotion extends Agent {

    /** Creates the solution. */
    public SmoothMotion() {}

    private static final Motion SALUTE =
            new Motion("salute", List.of(keyframe(400, 60), keyframe(400, -30), keyframe(600, 45), keyframe(400, 0)));

    private boolean played;

    @Override
    protected void think() {
        if (!played) {
            motions.setInterpolation(SmoothMotion::curve);
            played = motions.start(SALUTE);
        }
    }

    private static Keyframe keyframe(int millis, double degrees) {
        return new Keyframe(millis, Posture.ZERO.with(Joint.LEFT_SHOULDER_PITCH, degrees));
    }

    private static double curve(KeyframeInterval section, Joint joint, double t) {
        double from = section.from().degrees(joint);
        double to = section.to().degrees(joint);
        double millis = section.durationMillis();
        double start = slope(section.before().degrees(joint), to, section.durationBeforeMillis() + millis);
        double end = slope(from, section.after().degrees(joint), millis + section.durationAfterMillis());
        double rest = 1 - t;
        return from * rest * rest * (1 + 2 * t)
                + to * t * t * (1 + 2 * rest)
                + start * millis * t * rest * rest
                - end * millis * t * t * rest;
    }

    private static double slope(double from, double to, double millis) {
        return millis > 0 ? (to - from) / millis : 0;
    }
}
