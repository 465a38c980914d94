package org.robonewbie.simulator.physics.sparse;

import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.physics.Collider;
import org.robonewbie.simulator.physics.Contact;
import org.robonewbie.simulator.physics.ode.OdeCollisions;

/** A point where two colliders touch. The world uses it again in a later step. */
final class ContactPoint implements Contact {

    private static final Collider NOTHING = () -> "nothing";

    private Collider first = NOTHING;
    private Collider second = NOTHING;
    /** Place, normal and depth as {@link OdeCollisions} tells them. */
    final double[] numbers = new double[OdeCollisions.NUMBERS_PER_POINT];
    /** Force on the first collider's body. */
    final double[] force = new double[3];

    void set(Collider one, Collider other, double[] points, int index) {
        first = one;
        second = other;
        System.arraycopy(points, index * numbers.length, numbers, 0, numbers.length);
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
        return new Vector3(numbers[0], numbers[1], numbers[2]);
    }

    @Override
    public Vector3 forceOnFirst() {
        return new Vector3(force[0], force[1], force[2]);
    }

    @Override
    public void addTo(double[] sums) {
        double strength = Math.sqrt(Rotations.dot(force, 0, force, 0));
        for (int axis = 0; axis < 3; axis++) {
            sums[axis] += force[axis];
            sums[3 + axis] += strength * numbers[axis];
        }
        sums[6] += strength;
    }
}
