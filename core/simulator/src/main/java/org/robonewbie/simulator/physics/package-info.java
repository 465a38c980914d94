/**
 * Minimal interface to a rigid body engine, which makes the engine interchangeable. Read {@link
 * org.robonewbie.simulator.physics.PhysicsWorld} first.
 *
 * <p>Angles are in radians, all other quantities in metres, kilograms, seconds and newtons. Vectors are in the world frame
 * unless a method states otherwise.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.physics;
