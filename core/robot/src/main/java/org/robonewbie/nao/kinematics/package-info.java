/**
 * Forward kinematics, from joint angles to the poses of the limbs, and inverse kinematics, from the pose of a foot to joint
 * angles. Read {@link org.robonewbie.nao.kinematics.ForwardKinematics} first.
 *
 * <p>Unless stated otherwise, poses are relative to the torso, in the body frame of this framework: origin at the centre of the
 * torso's box, x forward, y to the left, z up, in metres. {@link org.robonewbie.nao.kinematics.SimSparkFrame} converts from and
 * to the simulator's frame.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.nao.kinematics;
