package org.robonewbie.simulator.physics.sparse;

import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.physics.Collider;
import org.robonewbie.simulator.physics.Contact;
import org.robonewbie.simulator.physics.ode.OdeCollisions;

/** Pooled contact point of two colliders. */
final class ContactPoint implements Contact {

    private static final Collider NONE = () -> "none";

    private Collider first = NONE;
    private Collider second = NONE;
    /** Position, normal and depth in the format of {@link OdeCollisions}. */
    final double[] geometry = new double[OdeCollisions.DOUBLES_PER_POINT];
    /** Force on the first collider's body. */
    final double[] force = new double[3];

    void set(Collider one, Collider other, double[] points, int index) {
        first = one;
        second = other;
        System.arraycopy(points, index * geometry.length, geometry, 0, geometry.length);
        force[0] = 0;
        force[1] = 0;
        force[2] = 0;
    }

    @Override
    public Collider first() {
        return first;
    }

    @Override
    public Collider second() {
        return second;
    }

    @Override
    public Vector3 position() {
        return new Vector3(geometry[0], geometry[1], geometry[2]);
    }

    @Override
    public void addTo(double[] sums) {
        double magnitude = Math.sqrt(Rotations.dot(force, 0, force, 0));
        for (int axis = 0; axis < 3; axis++) {
            sums[axis] += force[axis];
            sums[3 + axis] += magnitude * geometry[axis];
        }
        sums[6] += magnitude;
    }
}
