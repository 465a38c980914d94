package org.robonewbie.agent.perception;

import java.util.Locale;
import org.robonewbie.agent.log.Diagnostics;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.perceptor.PolarPosition;

/**
 * An object on the field in the robot's memory: seen now, some time ago, or never. The instance stays the same and is updated
 * with each camera picture, so programs may keep it.
 *
 * <p>All directions are relative to a head facing straight ahead. They date from the last sighting and do not
 * account for the robot's movement since then.
 *
 * <pre>{@code
 * FieldItem ball = fieldView.ball();
 * if (ball.ageSeconds() < 2 && Math.abs(ball.bearing()) < 6) { ... }
 * }</pre>
 */
public class FieldItem {

    private static final Direction NOWHERE = new Direction(Double.POSITIVE_INFINITY, 0, 0);

    private final String name;
    private final Vision vision;
    private final Diagnostics diagnostics;
    private double seenSeconds = Double.NEGATIVE_INFINITY;
    private PolarPosition sighting = new PolarPosition(0, 0, 0);
    private double yawDegrees;
    private double pitchDegrees;
    private CameraTransformation transformation = CameraTransformation.SUM_OF_ANGLES;
    private Direction direction = NOWHERE;
    private boolean directionIsOld;

    /** Time and head pose of the last picture, and the current time. */
    static final class Vision {
        double nowSeconds;
        double pictureSeconds = Double.NEGATIVE_INFINITY;
        double yawDegrees;
        double pitchDegrees;
        CameraTransformation transformation = CameraTransformation.SUM_OF_ANGLES;

        Direction facingForward(PolarPosition seen) {
            return FieldItem.facingForward(seen, yawDegrees, pitchDegrees, transformation);
        }
    }

    FieldItem(String name, Vision vision, Diagnostics diagnostics) {
        this.name = name;
        this.vision = vision;
        this.diagnostics = diagnostics;
    }

    /** Stores a sighting. The direction is computed on demand, because most directions are never read. */
    void see(PolarPosition newSighting) {
        sighting = newSighting;
        yawDegrees = vision.yawDegrees;
        pitchDegrees = vision.pitchDegrees;
        transformation = vision.transformation;
        see();
    }

    void see() {
        seenSeconds = vision.pictureSeconds;
        directionIsOld = true;
    }

    void forget() {
        seenSeconds = Double.NEGATIVE_INFINITY;
        direction = NOWHERE;
        directionIsOld = false;
    }

    private Direction direction() {
        if (directionIsOld) {
            direction = calculatedDirection();
            directionIsOld = false;
        }
        return direction;
    }

    Direction calculatedDirection() {
        return facingForward(sighting, yawDegrees, pitchDegrees, transformation);
    }

    private static Direction facingForward(
            PolarPosition seen, double yawDegrees, double pitchDegrees, CameraTransformation transformation) {
        Direction direction = new Direction(seen.distanceMetres(), seen.horizontalDegrees(), seen.verticalDegrees());
        return transformation.toFacingForward(direction, yawDegrees, pitchDegrees);
    }

    /** {@return whether the object was seen at least once since the start or the last beam} */
    public final boolean isKnown() {
        return seenSeconds > Double.NEGATIVE_INFINITY;
    }

    /** {@return whether the object is in the last picture; the camera takes one every third cycle} */
    public final boolean isVisible() {
        return isKnown() && seenSeconds == vision.pictureSeconds && ageSeconds() < 0.1;
    }

    /** {@return the time in seconds since the last sighting; infinite if there was none} */
    public final double ageSeconds() {
        return vision.nowSeconds - seenSeconds;
    }

    /**
     * {@return the simulated time of the last sighting in seconds, on the clock of {@code nao.getTime()}; minus
     * infinity if there was none}
     */
    public final double lastSeenSeconds() {
        return seenSeconds;
    }

    /**
     * Returns the distance along the ground from the point between the robot's feet, that is, the distance to walk. The
     * head of an upright robot is above that point.
     *
     * @return metres along the ground; infinite if the object was never seen
     */
    public final double distance() {
        return isKnown() ? direction().distanceOnGround() : Double.POSITIVE_INFINITY;
    }

    /**
     * Returns the measured distance from the camera. A ball at the feet is half a metre from the head.
     *
     * @return metres from the centre of the head; infinite if the object was never seen
     */
    public final double distanceFromHead() {
        return direction().distance();
    }

    /**
     * {@return the angle in degrees through which the robot has to turn to face the object; positive is left; 0 if the
     * object was never seen, in which case the call is reported}
     */
    public final double bearing() {
        checkKnown("bearing");
        return direction().bearing();
    }

    /**
     * {@return the angle in degrees above the horizontal plane of the head, negative is below; 0 if the object was
     * never seen, in which case the call is reported}
     */
    public final double elevation() {
        checkKnown("elevation");
        return direction().elevation();
    }

    /**
     * {@return the position relative to the centre of the head, in metres: x forward, y left, z up; the origin if the
     * object was never seen, in which case the call is reported}
     */
    public final Vector3 position() {
        checkKnown("position");
        return isKnown() ? direction().toPoint() : Vector3.ZERO;
    }

    private void checkKnown(String property) {
        if (!isKnown()) {
            diagnostics.report(
                    property + " of " + name,
                    () -> "The " + property + " of the " + name + " is unknown, since it has never been seen; call"
                            + " isKnown() first.");
        }
    }

    @Override
    public String toString() {
        return isKnown()
                ? String.format(Locale.ROOT, "%s %s, %.2f s ago", name, direction(), ageSeconds())
                : name + " never seen";
    }
}
