package org.robonewbie.simulator.physics.sparse;

import org.jspecify.annotations.Nullable;
import org.robonewbie.simulator.physics.ode.OdeCollisions;

/**
 * All points at which two bodies, or a body and something fixed, touch during one step: ODE's contact joints.
 *
 * <p>Three rows per point: along the normal the bodies must not come closer and only push; in the two directions across,
 * unlimited friction holds them but gives way softly (ODE's force dependent slip).
 */
final class ContactJoint extends ConstraintJoint {

    private static final int ROWS_PER_POINT = 3;

    private final ContactPoint[] points = new ContactPoint[OdeCollisions.MAX_POINTS];
    private int count;
    private ContactSurface surface = ContactSurface.HARD;
    private double sign;
    private LastTouch lastTouch = new LastTouch();

    /** The normal of a point and two directions across it. */
    private final double[] directions = new double[9];

    /** Creates an unused joint. */
    ContactJoint() {
        super(Body.NONE, null, false);
    }

    /**
     * Joins two bodies.
     *
     * @param first a body
     * @param second another one, or none
     * @param surface how they behave in contact
     * @param sign 1 if the points' normals look towards the first body, -1 if away from it
     * @param lastTouch what is remembered of the first body's shape
     * @return this joint
     */
    ContactJoint between(Body first, @Nullable Body second, ContactSurface surface, double sign, LastTouch lastTouch) {
        this.first = first;
        this.second = second;
        this.surface = surface;
        this.sign = sign;
        this.lastTouch = lastTouch;
        return this;
    }

    void add(ContactPoint point) {
        points[count++] = point;
    }

    /** Forgets its points and leaves its bodies; contacts are always the last of a body's joints. */
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
        for (int i = 0; i < count; i++) {
            writeRows(rows, firstRow + ROWS_PER_POINT * i, points[i].numbers, rate);
        }
    }

    private void writeRows(ConstraintRows rows, int row, double[] numbers, double rate) {
        for (int axis = 0; axis < 3; axis++) {
            directions[axis] = sign * numbers[3 + axis];
        }
        Rotations.squareTo(directions, 0, 3, 6);
        writeDirection(rows, row, numbers, 0);
        writeDirection(rows, row + 1, numbers, 3);
        writeDirection(rows, row + 2, numbers, 6);
        double depth = Math.max(0, numbers[6] - PhysicsConstants.CONTACT_SURFACE_LAYER);
        double approach = surface.bounces() ? -openingSpeed(rows, row) : 0;
        rows.wanted[row] = Math.max(rate * surface.errorReduction() * depth, surface.thrownBack(approach));
        rows.softness[row] = surface.softness();
        rows.softness[row + 1] = surface.slip();
        rows.softness[row + 2] = surface.slip();
        rows.lower[row] = 0;
    }

    private void writeDirection(ConstraintRows rows, int row, double[] numbers, int direction) {
        write(rows.first, row, first, numbers, directions, direction, 1);
        if (second != null) {
            write(rows.second, row, second, numbers, directions, direction, -1);
        }
    }

    private static void write(
            double[] jacobian, int row, Body body, double[] point, double[] directions, int at, double sign) {
        double[] centre = body.place();
        double armX = point[0] - centre[0];
        double armY = point[1] - centre[1];
        double armZ = point[2] - centre[2];
        double x = sign * directions[at];
        double y = sign * directions[at + 1];
        double z = sign * directions[at + 2];
        ConstraintRows.setLinear(jacobian, row, x, y, z);
        ConstraintRows.setAngular(jacobian, row, armY * z - armZ * y, armZ * x - armX * z, armX * y - armY * x);
    }

    private double openingSpeed(ConstraintRows rows, int row) {
        double speed = ConstraintRows.dot6(rows.first, 6 * row, first.velocity);
        return second == null ? speed : speed + ConstraintRows.dot6(rows.second, 6 * row, second.velocity);
    }

    @Override
    void setInitialBasis(ConstraintRows rows) {
        for (int i = 0; i < count && second == null; i++) {
            rows.state[firstRow + ROWS_PER_POINT * i] = lastTouch.stateAt(first, points[i].numbers);
        }
    }

    @Override
    void readForces(ConstraintRows rows) {
        readStates(rows);
        for (int i = 0; i < count; i++) {
            int row = firstRow + ROWS_PER_POINT * i;
            double[] force = points[i].force;
            for (int axis = 0; axis < 3; axis++) {
                force[axis] = rows.first[6 * row + axis] * rows.force[row]
                        + rows.first[6 * row + 6 + axis] * rows.force[row + 1]
                        + rows.first[6 * row + 12 + axis] * rows.force[row + 2];
            }
        }
    }

    private void readStates(ConstraintRows rows) {
        if (second == null) {
            lastTouch.clear();
            for (int i = 0; i < count; i++) {
                lastTouch.add(first, points[i].numbers, rows.state[firstRow + ROWS_PER_POINT * i]);
            }
        }
    }
}
