package org.robonewbie.team.world;

import org.robonewbie.agent.localisation.GroundPose;

/**
 * Notices that the teams have changed sides at half time. No message says so: but a robot that was beamed into its own half and sees
 * flags and goals as if it stood in the other one must be on the other side of the pitch.
 */
final class SideWatch {

    private static final double NEAR_METRES = 0.5;
    private static final double CERTAIN_SECONDS = 0.4;

    private boolean changed;
    private GroundPose beamedTo = GroundPose.ORIGIN;
    private double beamedSeconds = Double.NEGATIVE_INFINITY;

    /** Remembers where the robot wants to be, in the coordinates of the team. */
    void beamed(GroundPose place, double seconds) {
        beamedTo = place;
        beamedSeconds = seconds;
    }

    /** Compares where the robot wanted to be with where it sees itself. */
    void look(GroundPose seen, double seconds) {
        boolean waited = seconds - beamedSeconds > CERTAIN_SECONDS;
        if (waited && seconds - beamedSeconds < 2 && isAt(seen, turned(beamedTo))) {
            changed = !changed;
            beamedSeconds = Double.NEGATIVE_INFINITY;
        }
    }

    private static boolean isAt(GroundPose pose, GroundPose place) {
        return Spot.of(pose).distanceTo(Spot.of(place)) < NEAR_METRES
                && Spot.of(pose).length() > NEAR_METRES;
    }

    /** {@return whether the team plays on the other side than at the beginning} */
    boolean isChanged() {
        return changed;
    }

    /** Converts between the coordinates of the first and the present side. */
    GroundPose convert(GroundPose pose) {
        return changed ? turned(pose) : pose;
    }

    private static GroundPose turned(GroundPose pose) {
        return new GroundPose(-pose.x(), -pose.y(), pose.headingDegrees() + (pose.headingDegrees() > 0 ? -180 : 180));
    }
}
