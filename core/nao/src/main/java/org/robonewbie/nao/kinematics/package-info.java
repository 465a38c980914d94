/**
 * Where the robot's limbs are for given joint angles, and which angles bring a foot to a given place. Read {@link
 * org.robonewbie.nao.kinematics.ForwardKinematics} first.
 *
 * <p>Everything here is relative to the torso, in the body frame of this framework: origin in the centre of the torso's box, x
 * forward, y to the left, z up, metres. {@link org.robonewbie.nao.kinematics.SimSparkFrame} converts from and to the
 * simulator's frame.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.nao.kinematics;
