package org.robonewbie.agent.perception;

import org.robonewbie.nao.Vector3;

/**
 * Reading of the force sensor in one sole.
 *
 * @param point centre of pressure: x forward, y left, z up from the middle of the foot, in metres
 * @param force force exerted by the ground: x forward, y left, z up, in newtons; about (0, 0, 22.6) for each foot of a
 *     standing robot, (0, 0, 0) in the air
 */
public record FootPressure(Vector3 point, Vector3 force) {

    /** Reading for a foot in the air. */
    public static final FootPressure NONE = new FootPressure(Vector3.ZERO, Vector3.ZERO);

    /** {@return whether the foot touches anything} */
    public boolean isTouching() {
        return force.length() > 0;
    }
}
