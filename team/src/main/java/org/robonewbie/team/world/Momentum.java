package org.robonewbie.team.world;

import java.util.ArrayDeque;
import java.util.Deque;
import org.robonewbie.agent.localisation.GroundPose;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Vector3;

/**
 * Where the robot is when its motors do what it decides now. What the camera shows is three cycles old by then, so a robot that walks with
 * 0.7 m/s has come 4 cm further. That is as much as a foot may be beside the ball in a kick. What it has moved lately, it will
 * have moved once more.
 */
final class Momentum {

    private static final int CYCLES = 4;

    private final Deque<GroundPose> way = new ArrayDeque<>();
    private GroundPose step = GroundPose.ORIGIN;

    /**
     * Takes in one cycle.
     *
     * @param odometry where the robot is, in the frame of its odometry
     */
    void move(GroundPose odometry) {
        way.addLast(odometry);
        if (way.size() > CYCLES + 1) {
            way.removeFirst();
        }
        GroundPose before = way.getFirst();
        Spot moved = Spot.of(odometry).seenFrom(before);
        step = new GroundPose(moved.x(), moved.y(), odometry.headingDegrees() - before.headingDegrees());
    }

    /** {@return how fast the robot walks ahead, metres per second} */
    double speedAhead() {
        return step.x() / (CYCLES * Cycle.SECONDS);
    }

    /**
     * Moves a pose on.
     *
     * @param seen where the robot was when the camera took its picture
     * @return where it is when it acts
     */
    GroundPose after(GroundPose seen) {
        Vector3 place = seen.toFrame(new Vector3(step.x(), step.y(), 0));
        return new GroundPose(place.x(), place.y(), seen.headingDegrees() + step.headingDegrees());
    }
}
