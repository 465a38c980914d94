/**
 * What the world needs from a rigid-body engine, and nothing more, so that engines can be exchanged. Read {@link
 * org.robonewbie.simulator.physics.PhysicsWorld} first.
 *
 * <p>Angles are in radians here, all other quantities in metres, kilograms, seconds and newtons; every vector is in the
 * world frame unless a method says otherwise.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.physics;
