package org.robonewbie.agent.walk;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;

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

    /** The left foot of a standing robot. */
    public static final FootPlace LEFT = new FootPlace(0, HALF_WIDTH, 0);

    /** The right foot of a standing robot. */
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
        double cosine = PortableMath.cos(PortableMath.toRadians(degrees));
        double sine = PortableMath.sin(PortableMath.toRadians(degrees));
        return new FootPlace(cosine * forward - sine * left, sine * forward + cosine * left, yawDegrees + degrees);
    }

    /**
     * Moves on from this place along its own direction, and turns then.
     *
     * @param forwardMetres distance in the direction of the toes
     * @param leftMetres distance to the left of them
     * @param degrees change of direction, positive to the left
     * @return the new place
     */
    public FootPlace then(double forwardMetres, double leftMetres, double degrees) {
        double cosine = PortableMath.cos(PortableMath.toRadians(yawDegrees));
        double sine = PortableMath.sin(PortableMath.toRadians(yawDegrees));
        return new FootPlace(
                forward + (cosine * forwardMetres - sine * leftMetres),
                left + (sine * forwardMetres + cosine * leftMetres),
                yawDegrees + degrees);
    }

    /**
     * Goes a part of the way to another place.
     *
     * @param end the other place
     * @param fraction 0 for this place, 1 for the other
     * @return the place on the way
     */
    public FootPlace towards(FootPlace end, double fraction) {
        return new FootPlace(
                forward + fraction * (end.forward - forward),
                left + fraction * (end.left - left),
                yawDegrees + fraction * (end.yawDegrees - yawDegrees));
    }

    /**
     * Looks at this place from another one.
     *
     * @param middle the other place, looking along its direction
     * @return metres forward and to the left of it; z is 0
     */
    public Vector3 seenFrom(FootPlace middle) {
        double angle = PortableMath.toRadians(middle.yawDegrees);
        double cosine = PortableMath.cos(angle);
        double sine = PortableMath.sin(angle);
        return new Vector3(
                cosine * (forward - middle.forward) + sine * (left - middle.left),
                cosine * (left - middle.left) - sine * (forward - middle.forward),
                0);
    }
}
