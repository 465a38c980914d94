package org.robonewbie.simulator.physics.sparse;

import org.jspecify.annotations.Nullable;
import org.robonewbie.simulator.physics.ode.OdeCollisions;

/**
 * Contact constraint between two bodies, or a body and the static environment, with all contact points of one step.
 *
 * <p>Each point has three rows, like ODE's contact joint: a unilateral row along the normal, and two tangential rows with
 * unlimited friction and force-dependent slip.
 */
final class ContactJoint extends ConstraintJoint {

    private static final int ROWS_PER_POINT = 3;

    private final ContactPoint[] points = new ContactPoint[OdeCollisions.MAX_POINTS];
    private int count;
    private ContactSurface surface = ContactSurface.HARD;
    private double sign;
    private ContactStateCache contactStates = new ContactStateCache();

    /** Normal and two tangents at a contact point. */
    private final double[] directions = new double[9];

    ContactJoint() {
        super(Body.NONE, null, false);
    }

    /**
     * Reuses this object for a new contact.
     *
     * @param first a body
     * @param second the other body; null for the static environment
     * @param surface contact parameters
     * @param sign 1 if the normals point towards the first body, -1 if away from it
     * @param contactStates cache of the first body's shape
     * @return this joint
     */
    ContactJoint reset(
            Body first, @Nullable Body second, ContactSurface surface, double sign, ContactStateCache contactStates) {
        this.first = first;
        this.second = second;
        this.surface = surface;
        this.sign = sign;
        this.contactStates = contactStates;
        return this;
    }

    void add(ContactPoint point) {
        points[count++] = point;
    }

    /** Removes the points and detaches the joint from its bodies. Contacts are always the last joints of a body. */
    void detach() {
        count = 0;
        first.removeContacts();
        if (second != null) {
            second.removeContacts();
        }
    }

    @Override
    int rowCount() {
        return ROWS_PER_POINT * count;
    }

    @Override
    void writeRows(ConstraintRows rows, double rate) {
        double slip = surface.slip() / (second == null ? first.grip : first.grip * second.grip);
        for (int i = 0; i < count; i++) {
            writeRows(rows, firstRow + ROWS_PER_POINT * i, points[i].geometry, rate, slip);
        }
    }

    private void writeRows(ConstraintRows rows, int row, double[] geometry, double rate, double slip) {
        for (int axis = 0; axis < 3; axis++) {
            directions[axis] = sign * geometry[3 + axis];
        }
        Rotations.orthonormalBasis(directions, 0, 3, 6);
        writeDirection(rows, row, geometry, 0);
        writeDirection(rows, row + 1, geometry, 3);
        writeDirection(rows, row + 2, geometry, 6);
        double depth = Math.max(0, geometry[6] - PhysicsConstants.CONTACT_SURFACE_LAYER);
        double approach = surface.bounces() ? -separationSpeed(rows, row) : 0;
        rows.rightHandSide[row] = Math.max(rate * surface.errorReduction() * depth, surface.reboundSpeed(approach));
        rows.softness[row] = surface.softness();
        rows.softness[row + 1] = slip;
        rows.softness[row + 2] = slip;
        rows.lower[row] = 0;
    }

    private void writeDirection(ConstraintRows rows, int row, double[] geometry, int direction) {
        write(rows.firstJacobian, row, first, geometry, directions, direction, 1);
        if (second != null) {
            write(rows.secondJacobian, row, second, geometry, directions, direction, -1);
        }
    }

    private static void write(
            double[] jacobian, int row, Body body, double[] point, double[] directions, int at, double sign) {
        double[] centre = body.centre();
        double armX = point[0] - centre[0];
        double armY = point[1] - centre[1];
        double armZ = point[2] - centre[2];
        double x = sign * directions[at];
        double y = sign * directions[at + 1];
        double z = sign * directions[at + 2];
        ConstraintRows.setLinear(jacobian, row, x, y, z);
        ConstraintRows.setAngular(jacobian, row, armY * z - armZ * y, armZ * x - armX * z, armX * y - armY * x);
    }

    private double separationSpeed(ConstraintRows rows, int row) {
        double speed = ConstraintRows.dot6(rows.firstJacobian, 6 * row, first.velocity, 0);
        return second == null ? speed : speed + ConstraintRows.dot6(rows.secondJacobian, 6 * row, second.velocity, 0);
    }

    @Override
    void setInitialBasis(ConstraintRows rows) {
        for (int i = 0; i < count && second == null; i++) {
            rows.state[firstRow + ROWS_PER_POINT * i] = contactStates.stateAt(first, points[i].geometry);
        }
    }

    @Override
    void readForces(ConstraintRows rows) {
        readStates(rows);
        for (int i = 0; i < count; i++) {
            int row = firstRow + ROWS_PER_POINT * i;
            double[] force = points[i].force;
            for (int axis = 0; axis < 3; axis++) {
                force[axis] = rows.firstJacobian[6 * row + axis] * rows.force[row]
                        + rows.firstJacobian[6 * row + 6 + axis] * rows.force[row + 1]
                        + rows.firstJacobian[6 * row + 12 + axis] * rows.force[row + 2];
            }
        }
    }

    private void readStates(ConstraintRows rows) {
        if (second == null) {
            contactStates.clear();
            for (int i = 0; i < count; i++) {
                contactStates.add(first, points[i].geometry, rows.state[firstRow + ROWS_PER_POINT * i]);
            }
        }
    }
}
