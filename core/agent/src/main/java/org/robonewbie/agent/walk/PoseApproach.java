package org.robonewbie.agent.walk;

import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.math.PortableMath;

/**
 * Controller that walks to a target pose. Far from the target, the robot faces it and walks forward, its fastest direction;
 * close to it, the robot turns to the final heading and steps in any direction. It brakes in time: with the deceleration a, the
 * speed at distance d is √(2 a d).
 *
 * <pre>{@code
 * PoseApproach approach = new PoseApproach(WalkStyle.STANDARD);
 * // in each cycle:
 * WalkVelocity velocity = approach.velocity(ahead, left, turn);   // position and heading of the target, relative to the torso
 * walk.towards(velocity.forward(), velocity.left(), velocity.turn());
 * }</pre>
 *
 * @param style style of the walk; also pass it to {@link Walk#setStyle}
 */
public record PoseApproach(WalkStyle style) {

    private static final double FACES_PLACE_METRES = 0.6;
    private static final double FACES_HEADING_METRES = 0.25;
    private static final double PER_SECOND = 2;
    private static final double TURN_PER_SECOND = 2.2;
    private static final double BRAKES = 0.7;
    private static final double MAX_ASIDE_DEGREES = 60;

    /**
     * Computes the walking velocity.
     *
     * @param ahead distance from the torso to the target along the torso's forward axis, in metres
     * @param left distance from the torso to the target along the torso's left axis, in metres
     * @param turnDegrees target heading relative to the torso, positive to the left, -180 to 180
     * @return the velocity for this cycle, within the limits of the style
     */
    public WalkVelocity velocity(double ahead, double left, double turnDegrees) {
        double distance = PortableMath.hypot(ahead, left);
        double bearing = Angles.atan2(left, ahead);
        double far = facingWeight(distance);
        double turn = TURN_PER_SECOND * (far * bearing + (1 - far) * turnDegrees);
        if (distance > FACES_PLACE_METRES && Math.abs(bearing) > MAX_ASIDE_DEGREES) {
            return new WalkVelocity(0, 0, turn).within(style.most(), style.backward());
        }
        double speed = Math.min(PER_SECOND * distance, braking(distance));
        double perMetre = speed / Math.max(1e-6, distance);
        return new WalkVelocity(perMetre * ahead, (1 - far) * perMetre * left, turn)
                .within(style.most(), style.backward());
    }

    /** Returns the weight of facing the target: 1 far away, 0 at the target, where the final heading counts. */
    private static double facingWeight(double distance) {
        double share = (distance - FACES_HEADING_METRES) / (FACES_PLACE_METRES - FACES_HEADING_METRES);
        return Math.max(0, Math.min(1, share));
    }

    private double braking(double distance) {
        double deceleration = 1000 * style.change().forward() / style.gait().stepMillis();
        return Math.sqrt(2 * BRAKES * deceleration * distance);
    }
}
