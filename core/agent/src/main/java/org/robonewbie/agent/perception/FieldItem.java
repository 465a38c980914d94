package org.robonewbie.agent.perception;

import java.util.Locale;
import org.robonewbie.agent.log.Diagnostics;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.perceptor.PolarPosition;

/**
 * An object on the field as the robot remembers it: seen now, some time ago, or never. The instance stays the same and is
 * updated with each picture of the camera, so you can keep it.
 *
 * <p>All directions are those of a robot that looks straight ahead; they are as old as the last sighting and do not follow the
 * robot's own movement since then.
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

    /** When and how the camera took its last picture, and what time it is. */
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

    /** Keeps what the camera sees; the direction is calculated on demand, since most directions are never asked for. */
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

    /** {@return whether this was seen at least once since the start or the last beam} */
    public final boolean isKnown() {
        return seenSeconds > Double.NEGATIVE_INFINITY;
    }

    /** {@return whether this was in the last picture; the camera takes one in each third cycle} */
    public final boolean isVisible() {
        return isKnown() && seenSeconds == vision.pictureSeconds && ageSeconds() < 0.1;
    }

    /** {@return seconds since this was last seen; infinite if it never was} */
    public final double ageSeconds() {
        return vision.nowSeconds - seenSeconds;
    }

    /** {@return when this was last seen, in simulated seconds as {@code nao.getTime()}; minus infinity if it never was} */
    public final double lastSeenSeconds() {
        return seenSeconds;
    }

    /**
     * Returns how far away this is on the pitch, measured from the point between the robot's feet: what the robot has to walk. A
     * robot that stands or walks has its head above that point.
     *
     * @return metres along the ground; infinite if this was never seen
     */
    public final double distance() {
        return isKnown() ? direction().distanceOnGround() : Double.POSITIVE_INFINITY;
    }

    /**
     * Returns how far away this is from the camera, as it is measured. A ball at the feet is half a metre from the head.
     *
     * @return metres from the centre of the head; infinite if this was never seen
     */
    public final double distanceFromHead() {
        return direction().distance();
    }

    /** {@return degrees that the robot has to turn to face this, positive is left; 0 and a report if it was never seen} */
    public final double bearing() {
        checkKnown("bearing");
        return direction().bearing();
    }

    /** {@return degrees above the level of the head, negative is below; 0 and a report if this was never seen} */
    public final double elevation() {
        checkKnown("elevation");
        return direction().elevation();
    }

    /** {@return metres from the centre of the head: x forward, y left, z up; the origin and a report if this was never seen} */
    public final Vector3 position() {
        checkKnown("position");
        return isKnown() ? direction().toPoint() : Vector3.ZERO;
    }

    private void checkKnown(String question) {
        if (!isKnown()) {
            diagnostics.report(
                    question + " of " + name,
                    () -> "The " + question + " of the " + name + " is not known, since it has never been seen; ask"
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
