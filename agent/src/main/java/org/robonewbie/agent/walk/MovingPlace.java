package org.robonewbie.agent.walk;

/** A {@link FootPlace} that changes while the robot walks, so that no step makes garbage. */
final class MovingPlace {

    private double forward;
    private double left;
    private double yawDegrees;

    MovingPlace() {}

    MovingPlace(FootPlace start) {
        set(start);
    }

    /** Metres ahead of where the walk began. */
    double forward() {
        return forward;
    }

    /** Metres to the left of where the walk began. */
    double left() {
        return left;
    }

    /** Where the toes point; positive is to the left. */
    double yawDegrees() {
        return yawDegrees;
    }

    void set(FootPlace place) {
        forward = place.forward();
        left = place.left();
        yawDegrees = place.yawDegrees();
    }

    void set(MovingPlace place) {
        forward = place.forward;
        left = place.left;
        yawDegrees = place.yawDegrees;
    }

    /** Goes a part of the way to another place. */
    void approach(MovingPlace other, double fraction) {
        forward += fraction * (other.forward - forward);
        left += fraction * (other.left - left);
        yawDegrees += fraction * (other.yawDegrees - yawDegrees);
    }

    /** Goes on along its own direction, and turns then. */
    void go(double forwardMetres, double leftMetres, double degrees) {
        double cosine = Math.cos(Math.toRadians(yawDegrees));
        double sine = Math.sin(Math.toRadians(yawDegrees));
        forward += cosine * forwardMetres - sine * leftMetres;
        left += sine * forwardMetres + cosine * leftMetres;
        yawDegrees += degrees;
    }

    /** How far this is ahead of another place, which looks along its own direction. */
    double aheadOf(MovingPlace middle) {
        double angle = Math.toRadians(middle.yawDegrees);
        return Math.cos(angle) * (forward - middle.forward) + Math.sin(angle) * (left - middle.left);
    }

    /** How far this is to the left of another place, which looks along its own direction. */
    double leftOf(MovingPlace middle) {
        double angle = Math.toRadians(middle.yawDegrees);
        return Math.cos(angle) * (left - middle.left) - Math.sin(angle) * (forward - middle.forward);
    }

    FootPlace toPlace() {
        return new FootPlace(forward, left, yawDegrees);
    }
}
