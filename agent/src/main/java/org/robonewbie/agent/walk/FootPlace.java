package org.robonewbie.agent.walk;

import org.robonewbie.nao.Vector3;

/**
 * Where a foot stands on the ground: the point of its sole below the ankle.
 *
 * @param forward metres ahead of where the walk began
 * @param left metres to the left of where the walk began
 * @param yawDegrees where the toes point; positive is to the left
 */
public record FootPlace(double forward, double left, double yawDegrees) {

    /** Half the distance between two feet that stand side by side below the hips, in metres. */
    public static final double HALF_WIDTH = 0.055;

    /** The left foot of a robot that stands still. */
    public static final FootPlace LEFT = new FootPlace(0, HALF_WIDTH, 0);

    /** The right foot of a robot that stands still. */
    public static final FootPlace RIGHT = new FootPlace(0, -HALF_WIDTH, 0);

    /**
     * Moves the place along the axes of the walk's beginning.
     *
     * @param forwardMetres way forward
     * @param leftMetres way to the left
     * @return the new place with the same direction
     */
    public FootPlace moved(double forwardMetres, double leftMetres) {
        return new FootPlace(forward + forwardMetres, left + leftMetres, yawDegrees);
    }

    /**
     * Turns place and direction about the point from where the walk began.
     *
     * @param degrees angle, positive to the left
     * @return the new place
     */
    public FootPlace turned(double degrees) {
        double cosine = Math.cos(Math.toRadians(degrees));
        double sine = Math.sin(Math.toRadians(degrees));
        return new FootPlace(cosine * forward - sine * left, sine * forward + cosine * left, yawDegrees + degrees);
    }

    /**
     * Goes on from this place along its own direction.
     *
     * @param forwardMetres way to where the toes point
     * @param leftMetres way to the left of them
     * @param degrees change of direction, positive to the left
     * @return the new place
     */
    public FootPlace then(double forwardMetres, double leftMetres, double degrees) {
        MovingPlace place = new MovingPlace(this);
        place.go(forwardMetres, leftMetres, degrees);
        return place.toPlace();
    }

    /**
     * Tells where this place is as seen from another one.
     *
     * @param middle the other place, looking along its direction
     * @return metres forward and to the left of it; z is 0
     */
    public Vector3 seenFrom(FootPlace middle) {
        MovingPlace seen = new MovingPlace(this);
        MovingPlace from = new MovingPlace(middle);
        return new Vector3(seen.aheadOf(from), seen.leftOf(from), 0);
    }
}
