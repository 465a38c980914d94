package org.robonewbie.team.world;

import org.robonewbie.agent.localisation.GroundPose;
import org.robonewbie.agent.localisation.SelfLocalisation;
import org.robonewbie.agent.perception.FieldItem;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Vector3;

/**
 * Follows the ball with a {@link BallFilter}. The filter lives in the frame of the pitch as the robot sees its team at the beginning: there
 * the ball keeps its place while the robot walks, falls and gets up. A robot that leans sees the ball aside of where it lies, so what
 * it sees is levelled first.
 */
final class BallTracker {

    private static final double NEAR_DEVIATION = 0.015;
    private static final double DEVIATION_PER_METRE = 0.012;

    /** The camera is above the torso's centre, of which the robot knows the place. */
    private static final Vector3 CAMERA = new Vector3(0, 0, 0.155);

    private final BallFilter filter = new BallFilter();
    private GroundPose here = GroundPose.ORIGIN;
    private double seenSeconds = Double.NEGATIVE_INFINITY;

    /** Lets the ball roll on by a cycle. */
    void roll() {
        if (filter.isKnown()) {
            filter.roll(Cycle.SECONDS);
        }
    }

    /** Moves with the robot. */
    void move(SelfLocalisation self) {
        here = self.pose();
    }

    /** Looks at the ball if there is a new picture. */
    void look(SelfLocalisation self, FieldItem ball, double seconds) {
        if (ball.isKnown() && ball.ageSeconds() == 0) {
            Spot seen = Spot.of(self.levelled(ball.position().plus(CAMERA)));
            filter.see(seen.onMap(here), NEAR_DEVIATION + DEVIATION_PER_METRE * ball.distance());
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
    Spot position() {
        return filter.position().seenFrom(here);
    }

    /** How the ball rolls, in the directions of the robot, metres per second. */
    Spot velocity() {
        return filter.velocity().seenFrom(new GroundPose(0, 0, here.headingDegrees()));
    }
}
