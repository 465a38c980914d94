package org.robonewbie.team.world;

import org.robonewbie.agent.localisation.SelfLocalisation;
import org.robonewbie.agent.perception.FieldItem;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.geometry.Translation2d;

/**
 * Ball tracker with a {@link BallFilter}, in a frame that does not move with the robot. There are two variants. The default one
 * uses the odometry frame and assumes that the torso is upright; kicks and tactics are tuned for it. The exact one uses the
 * field's frame and compensates for the tilt of the torso, which displaces the ball in the image.
 */
final class BallTracker {

    private static final double NEAR_DEVIATION = 0.015;
    private static final double DEVIATION_PER_METRE = 0.012;

    /** Position of the camera relative to the torso's centre. */
    private static final Vector3 CAMERA = new Vector3(0, 0, 0.155);

    private final boolean exact;
    private final BallFilter filter = new BallFilter();
    private Pose2d here = Pose2d.ORIGIN;
    private double seenSeconds = Double.NEGATIVE_INFINITY;

    /** Creates a tracker without an estimate. */
    BallTracker(boolean exact) {
        this.exact = exact;
    }

    /** Advances the estimate by one cycle. */
    void roll() {
        if (filter.isKnown()) {
            filter.roll(Cycle.SECONDS);
        }
    }

    /** Corrects the estimate if there is a new image. */
    void look(SelfLocalisation self, FieldItem ball, double seconds) {
        here = exact ? self.pose() : self.odometry().pose();
        if (ball.isKnown() && ball.ageSeconds() == 0) {
            Vector3 seen = exact ? self.levelled(ball.position().plus(CAMERA)) : ball.position();
            filter.see(Translation2d.of(seen).onMap(here), NEAR_DEVIATION + DEVIATION_PER_METRE * ball.distance());
            seenSeconds = seconds;
        }
    }

    /** Clears the estimate. Call after the robot has been placed elsewhere. */
    void reset() {
        filter.reset();
        seenSeconds = Double.NEGATIVE_INFINITY;
    }

    /** Returns the simulated time of the last sighting in seconds. */
    double seenSeconds() {
        return seenSeconds;
    }

    /** Returns the position of the ball in the robot's frame. */
    Translation2d position() {
        return filter.position().seenFrom(here);
    }

    /** Returns the velocity of the ball in the robot's frame in metres per second. */
    Translation2d velocity() {
        return filter.velocity().seenFrom(new Pose2d(0, 0, here.degrees()));
    }
}
