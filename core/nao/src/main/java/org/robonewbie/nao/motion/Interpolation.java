package org.robonewbie.nao.motion;

import org.robonewbie.nao.Joint;

/**
 * The path of a joint between two keyframes. Implement it to make motions smoother.
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

    /** Constant speed from one keyframe to the next. */
    Interpolation LINEAR = new LinearInterpolation();

    /**
     * Returns the angle of a joint on its way.
     *
     * @param section the interval between two keyframes, with its neighbours
     * @param joint the joint
     * @param fraction elapsed fraction of the time, from 0 at the interval's start to 1 at its end
     * @return the joint's angle in degrees
     */
    double degrees(KeyframeInterval section, Joint joint, double fraction);
}
