package org.robonewbie.nao.motion;

import org.robonewbie.nao.Joint;

/**
 * The path of a joint between two keyframes. Implement this interface for smoother motions.
 *
 * <pre>{@code
 * Interpolation smooth = (section, joint, fraction) -> {
 *     double eased = fraction * fraction * (3 - 2 * fraction);
 *     return section.from().degrees(joint) * (1 - eased) + section.to().degrees(joint) * eased;
 * };
 * }</pre>
 */
@FunctionalInterface
public interface Interpolation {

    /** Constant speed from one keyframe to the next; the speed changes abruptly at each keyframe. */
    Interpolation LINEAR = (section, joint, fraction) -> section.linearDegrees(joint.ordinal(), fraction);

    /**
     * Returns the angle of a joint within an interval.
     *
     * @param section the interval between two keyframes, with the neighbouring keyframes
     * @param joint the joint
     * @param fraction elapsed fraction of the interval, from 0 at its start to 1 at its end
     * @return the joint's angle in degrees
     */
    double degrees(KeyframeInterval section, Joint joint, double fraction);
}
