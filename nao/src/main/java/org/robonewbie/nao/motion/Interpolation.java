package org.robonewbie.nao.motion;

import org.robonewbie.nao.Joint;

/**
 * The way that a joint takes between two keyframes. Write your own to make motions smoother.
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

    /** At the same speed all the way. */
    Interpolation LINEAR = new LinearInterpolation();

    /**
     * Finds where a joint shall be.
     *
     * @param section the way between two keyframes, with its neighbours
     * @param joint the joint
     * @param fraction which part of the time is over, from 0 at the section's start to 1 at its end
     * @return the joint's angle in degrees
     */
    double degrees(MotionSection section, Joint joint, double fraction);
}
