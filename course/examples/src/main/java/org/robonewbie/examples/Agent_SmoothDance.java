package org.robonewbie.examples;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.Options;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Interpolation;
import org.robonewbie.nao.motion.KeyframeInterval;

/**
 * Plays the dance with smooth curves instead of straight lines between keyframes, using a custom interpolation in a dozen
 * lines of code. Watch how the arms pass through a keyframe instead of changing speed abruptly.
 *
 * <p>With the argument {@code linear}, it uses the default interpolation, for comparison.
 */
public final class Agent_SmoothDance extends Agent {

    /** Creates the agent. */
    public Agent_SmoothDance() {}

    /**
     * Starts the robot.
     *
     * @param args {@code linear} for straight lines, and options such as {@code --headless}
     */
    public static void main(String[] args) {
        new Agent_SmoothDance().run(args);
    }

    @Override
    protected Options defaults() {
        return Options.none().withWords().withPose(-1, 0, 0);
    }

    @Override
    protected void think() {
        motions.setInterpolation(options().arguments().contains("linear") ? Interpolation.LINEAR : new Spline());
        motions.start("dance");
    }

    /**
     * Cubic Catmull-Rom spline through all keyframes: at each keyframe the joint has the mean velocity of the two adjacent
     * segments.
     */
    static final class Spline implements Interpolation {

        @Override
        public double degrees(KeyframeInterval section, Joint joint, double fraction) {
            double from = section.from().degrees(joint);
            double to = section.to().degrees(joint);
            double seconds = section.durationMillis();
            double startSlope = slope(section.before().degrees(joint), to, section.durationBeforeMillis() + seconds);
            double endSlope = slope(from, section.after().degrees(joint), seconds + section.durationAfterMillis());
            double t = fraction;
            double rest = 1 - t;
            return from * rest * rest * (1 + 2 * t)
                    + to * t * t * (1 + 2 * rest)
                    + startSlope * seconds * t * rest * rest
                    - endSlope * seconds * t * t * rest;
        }

        private static double slope(double from, double to, double duration) {
            return duration > 0 ? (to - from) / duration : 0;
        }
    }
}
