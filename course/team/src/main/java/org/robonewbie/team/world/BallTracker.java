package org.robonewbie.team.world;

import org.robonewbie.agent.localisation.SelfLocalisation;
import org.robonewbie.agent.perception.FieldItem;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.geometry.Translation2d;

/**
 * Follows the ball with a {@link BallFilter}. The filter lives in a frame in which the ball keeps its place while the robot walks. There are
 * two of them. The usual one is that of the odometry, and the torso is taken for upright: kick and tactics are tuned for that. The exact one
 * is the pitch, and what is seen is levelled first, since a robot that leans sees the ball aside of where it lies.
 */
final class BallTracker {

    private static final double NEAR_DEVIATION = 0.015;
    private static final double DEVIATION_PER_METRE = 0.012;

    /** The camera is above the torso's centre, of which the robot knows the place. */
    private static final Vector3 CAMERA = new Vector3(0, 0, 0.155);

    private final boolean exact;
    private final BallFilter filter = new BallFilter();
    private Pose2d here = Pose2d.ORIGIN;
    private double seenSeconds = Double.NEGATIVE_INFINITY;

    /** Knows no ball yet. */
    BallTracker(boolean exact) {
        this.exact = exact;
    }

    /** Lets the ball roll on by a cycle. */
    void roll() {
        if (filter.isKnown()) {
            filter.roll(Cycle.SECONDS);
        }
    }

    /** Looks at the ball if there is a new picture. */
    void look(SelfLocalisation self, FieldItem ball, double seconds) {
        here = exact ? self.pose() : self.odometry().pose();
        if (ball.isKnown() && ball.ageSeconds() == 0) {
            Vector3 seen = exact ? self.levelled(ball.position().plus(CAMERA)) : ball.position();
            filter.see(Translation2d.of(seen).onMap(here), NEAR_DEVIATION + DEVIATION_PER_METRE * ball.distance());
            seenSeconds = seconds;
        }
    }

    /** Forgets the ball, since the robot was put somewhere else. */
    void reset() {
        filter.reset();
        seenSeconds = Double.NEGATIVE_INFINITY;
    }

    /** When the ball was last seen. */
    double seenSeconds() {
        return seenSeconds;
    }

    /** Where the ball is, seen from the robot. */
    Translation2d position() {
        return filter.position().seenFrom(here);
    }

    /** How the ball rolls, in the directions of the robot, metres per second. */
    Translation2d velocity() {
        return filter.velocity().seenFrom(new Pose2d(0, 0, here.degrees()));
    }
}
