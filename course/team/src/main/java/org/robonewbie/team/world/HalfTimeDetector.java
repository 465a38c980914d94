package org.robonewbie.team.world;

import org.robonewbie.nao.geometry.Pose2d;

/**
 * Detects the change of sides at half time, which no message announces: a robot that has beamed into its own half but sees the
 * landmarks of the other half must be on the other side of the field.
 */
final class HalfTimeDetector {

    private static final double NEAR_METRES = 0.5;
    private static final double CERTAIN_SECONDS = 0.4;

    private boolean changed;
    private Pose2d beamedTo = Pose2d.ORIGIN;
    private double beamedSeconds = Double.NEGATIVE_INFINITY;

    /** Records that the robot has beamed to a pose, in team coordinates. */
    void beamed(Pose2d place, double seconds) {
        beamedTo = place;
        beamedSeconds = seconds;
    }

    /** Compares the pose to which the robot has beamed with the pose estimated from landmarks. */
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

    /** {@return whether the team has changed sides since the start of the game} */
    boolean isChanged() {
        return changed;
    }

    /** Converts a pose between the coordinates of the team's first side and those of its current side, in either direction. */
    Pose2d convert(Pose2d pose) {
        return changed ? turned(pose) : pose;
    }

    private static Pose2d turned(Pose2d pose) {
        return new Pose2d(-pose.x(), -pose.y(), pose.degrees() + (pose.degrees() > 0 ? -180 : 180));
    }
}
