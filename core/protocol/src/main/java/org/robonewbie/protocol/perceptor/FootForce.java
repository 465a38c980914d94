package org.robonewbie.protocol.perceptor;

import org.robonewbie.nao.Vector3;

/**
 * The contact force on one foot: perceptor {@code FRP}.
 *
 * <p>Both vectors are in the foot's frame: origin at the centre of the foot's box, x to the right, y forward, z up.
 *
 * @param point mean point of application of the force in metres
 * @param force sum of the contact forces in newtons; about (0, 0, 22.6) for each foot of a standing robot
 */
public record FootForce(Vector3 point, Vector3 force) {}
