package org.robonewbie.team.world;

import org.robonewbie.nao.geometry.Pose2d;

/**
 * Notices that the teams have changed sides at half time. No message says so: but a robot that was beamed into its own half and sees
 * flags and goals as if it stood in the other one must be on the other side of the pitch.
 */
final class HalfTimeDetector {

    private static final double NEAR_METRES = 0.5;
    private static final double CERTAIN_SECONDS = 0.4;

    private boolean changed;
    private Pose2d beamedTo = Pose2d.ORIGIN;
    private double beamedSeconds = Double.NEGATIVE_INFINITY;

    /** Remembers where the robot wants to be, in the coordinates of the team. */
    void beamed(Pose2d place, double seconds) {
        beamedTo = place;
        beamedSeconds = seconds;
    }

    /** Compares where the robot wanted to be with where it sees itself. */
    void look(Pose2d seen, double seconds) {
        boolean waited = seconds - beamedSeconds > CERTAIN_SECONDS;
        if (waited && seconds - beamedSeconds < 2 && isAt(seen, turned(beamedTo))) {
            changed = !changed;
            beamedSeconds = Double.NEGATIVE_INFINITY;
        }
    }

    private static boolean isAt(Pose2d pose, Pose2d place) {
        return pose.translation().distanceTo(place.translation()) < NEAR_METRES
                && pose.translation().length() > NEAR_METRES;
    }

    /** {@return whether the team plays on the other side than at the beginning} */
    boolean isChanged() {
        return changed;
    }

    /** Converts between the coordinates of the first and the present side. */
    Pose2d convert(Pose2d pose) {
        return changed ? turned(pose) : pose;
    }

    private static Pose2d turned(Pose2d pose) {
        return new Pose2d(-pose.x(), -pose.y(), pose.degrees() + (pose.degrees() > 0 ? -180 : 180));
    }
}
