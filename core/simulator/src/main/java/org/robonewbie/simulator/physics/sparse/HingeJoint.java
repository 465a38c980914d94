package org.robonewbie.simulator.physics.sparse;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.simulator.physics.HingeDefinition;
import org.robonewbie.simulator.physics.MotorHinge;

/**
 * A hinge with motor and stops: ODE's hinge joint ({@code joints/hinge.cpp}, {@code dxJointLimitMotor}).
 *
 * <p>Six rows: three hold the anchors together, two the axes, and the sixth is the motor, or a stop while the angle is at
 * or beyond it.
 */
final class HingeJoint extends ConstraintJoint implements MotorHinge, Restorable {

    private static final int ROWS = 6;
    private static final int ANCHOR_ON_CHILD = 0;
    private static final int ANCHOR_ON_PARENT = 3;
    private static final int AXIS_ON_CHILD = 6;
    private static final int AXIS_ON_PARENT = 9;
    private static final int START_TURN = 12;

    private final Body child;
    private final Body parent;
    private final HingeDefinition definition;
    /** What never changes, in one array, since hundreds of robots share the processor's cache. */
    private final double[] fixed = new double[16];

    private double speed;
    private double angle;
    private int childTurns = -1;
    private int parentTurns = -1;

    HingeJoint(Body child, Body parent, HingeDefinition definition) {
        super(child, parent, true);
        this.child = child;
        this.parent = parent;
        this.definition = definition;
        double[] anchor = array(definition.anchor());
        fix(child, anchor, fixed, ANCHOR_ON_CHILD);
        fix(parent, anchor, fixed, ANCHOR_ON_PARENT);
        double[] direction = array(definition.axis().times(1 / definition.axis().length()));
        Rotations.applyInverse(child.rotation, direction, fixed, AXIS_ON_CHILD);
        Rotations.applyInverse(parent.rotation, direction, fixed, AXIS_ON_PARENT);
        fixTurn();
    }

    private static void fix(Body body, double[] point, double[] fixed, int at) {
        double[] centre = body.place();
        double[] arm = {point[0] - centre[0], point[1] - centre[1], point[2] - centre[2]};
        Rotations.applyInverse(body.rotation, arm, fixed, at);
    }

    private static double[] array(Vector3 vector) {
        return new double[] {vector.x(), vector.y(), vector.z()};
    }

    /** Keeps the parent's orientation seen from the child: conjugate(child) · parent. */
    private void fixTurn() {
        double[] a = child.orientation();
        double[] b = parent.orientation();
        fixed[START_TURN] = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
        fixed[START_TURN + 1] = a[0] * b[1] - a[1] * b[0] - a[2] * b[3] + a[3] * b[2];
        fixed[START_TURN + 2] = a[0] * b[2] - a[2] * b[0] - a[3] * b[1] + a[1] * b[3];
        fixed[START_TURN + 3] = a[0] * b[3] - a[3] * b[0] - a[1] * b[2] + a[2] * b[1];
    }

    @Override
    public void setSpeed(double radiansPerSecond) {
        speed = radiansPerSecond;
    }

    @Override
    public double angleRadians() {
        if (childTurns != child.turns() || parentTurns != parent.turns()) {
            angle = measureAngle();
            childTurns = child.turns();
            parentTurns = parent.turns();
        }
        return angle;
    }

    /** The turn of the parent seen from the child, as in {@link #fixTurn}, and from there back to the turn at the start. */
    private double measureAngle() {
        double[] a = child.orientation();
        double[] b = parent.orientation();
        double nowW = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
        double nowX = a[0] * b[1] - a[1] * b[0] - a[2] * b[3] + a[3] * b[2];
        double nowY = a[0] * b[2] - a[2] * b[0] - a[3] * b[1] + a[1] * b[3];
        double nowZ = a[0] * b[3] - a[3] * b[0] - a[1] * b[2] + a[2] * b[1];
        double startW = fixed[START_TURN];
        double startX = fixed[START_TURN + 1];
        double startY = fixed[START_TURN + 2];
        double startZ = fixed[START_TURN + 3];
        double w = nowW * startW + nowX * startX + nowY * startY + nowZ * startZ;
        double x = -nowW * startX + nowX * startW - nowY * startZ + nowZ * startY;
        double y = -nowW * startY + nowY * startW - nowZ * startX + nowX * startZ;
        double z = -nowW * startZ + nowZ * startW - nowX * startY + nowY * startX;
        double sine = Math.sqrt(x * x + y * y + z * z);
        boolean forward = Rotations.dot(x, y, z, fixed, AXIS_ON_CHILD) >= 0;
        double turned = 2 * PortableMath.atan2(sine, forward ? w : -w);
        return -(turned > Math.PI ? turned - 2 * Math.PI : turned);
    }

    @Override
    int rowCount() {
        return ROWS;
    }

    @Override
    void writeRows(ConstraintRows rows, double rate) {
        holdAnchors(rows, rate);
        holdAxes(rows, rate);
        int row = firstRow + 5;
        rows.softness[row] = definition.softness();
        double now = angleRadians();
        if (now <= definition.minRadians()) {
            stop(rows, rate, now - definition.minRadians(), 1);
        } else if (now >= definition.maxRadians()) {
            stop(rows, rate, now - definition.maxRadians(), -1);
        } else {
            rows.wanted[row] = speed;
            rows.lower[row] = -definition.maxTorque();
            rows.upper[row] = definition.maxTorque();
        }
    }

    private void holdAnchors(ConstraintRows rows, double rate) {
        double[] turn = child.rotation;
        double childX = Rotations.dot(turn, 0, fixed, ANCHOR_ON_CHILD);
        double childY = Rotations.dot(turn, 3, fixed, ANCHOR_ON_CHILD);
        double childZ = Rotations.dot(turn, 6, fixed, ANCHOR_ON_CHILD);
        double[] otherTurn = parent.rotation;
        double parentX = Rotations.dot(otherTurn, 0, fixed, ANCHOR_ON_PARENT);
        double parentY = Rotations.dot(otherTurn, 3, fixed, ANCHOR_ON_PARENT);
        double parentZ = Rotations.dot(otherTurn, 6, fixed, ANCHOR_ON_PARENT);
        crossRows(rows.first, 1, childX, childY, childZ);
        crossRows(rows.second, -1, -parentX, -parentY, -parentZ);
        double pull = rate * PhysicsConstants.ERROR_REDUCTION;
        double[] place = child.place();
        double[] otherPlace = parent.place();
        rows.wanted[firstRow] = pull * (parentX + otherPlace[0] - childX - place[0]);
        rows.wanted[firstRow + 1] = pull * (parentY + otherPlace[1] - childY - place[1]);
        rows.wanted[firstRow + 2] = pull * (parentZ + otherPlace[2] - childZ - place[2]);
    }

    /** The velocity of a point on a body is v + w × arm; one row for each direction. */
    private void crossRows(double[] jacobian, double sign, double x, double y, double z) {
        ConstraintRows.setLinear(jacobian, firstRow, sign, 0, 0);
        ConstraintRows.setAngular(jacobian, firstRow, 0, z, -y);
        ConstraintRows.setLinear(jacobian, firstRow + 1, 0, sign, 0);
        ConstraintRows.setAngular(jacobian, firstRow + 1, -z, 0, x);
        ConstraintRows.setLinear(jacobian, firstRow + 2, 0, 0, sign);
        ConstraintRows.setAngular(jacobian, firstRow + 2, y, -x, 0);
    }

    /** The last row turns about the axis of the child, and the two before it across. */
    private void holdAxes(ConstraintRows rows, double rate) {
        double[] turn = child.rotation;
        double x = Rotations.dot(turn, 0, fixed, AXIS_ON_CHILD);
        double y = Rotations.dot(turn, 3, fixed, AXIS_ON_CHILD);
        double z = Rotations.dot(turn, 6, fixed, AXIS_ON_CHILD);
        double[] otherTurn = parent.rotation;
        double parentX = Rotations.dot(otherTurn, 0, fixed, AXIS_ON_PARENT);
        double parentY = Rotations.dot(otherTurn, 3, fixed, AXIS_ON_PARENT);
        double parentZ = Rotations.dot(otherTurn, 6, fixed, AXIS_ON_PARENT);
        double[] turns = rows.first;
        int axis = axisAt();
        Rotations.set(turns, axis, x, y, z);
        Rotations.squareTo(turns, axis, axis - 12, axis - 6);
        oppose(turns, rows.second);
        double errorX = y * parentZ - z * parentY;
        double errorY = z * parentX - x * parentZ;
        double errorZ = x * parentY - y * parentX;
        double pull = rate * PhysicsConstants.ERROR_REDUCTION;
        rows.wanted[firstRow + 3] = pull * Rotations.dot(errorX, errorY, errorZ, turns, axis - 12);
        rows.wanted[firstRow + 4] = pull * Rotations.dot(errorX, errorY, errorZ, turns, axis - 6);
    }

    /** Where the axis of the child is among the Jacobians: the angular part of the last row. */
    private int axisAt() {
        return 6 * (firstRow + 5) + 3;
    }

    /** Rows that only turn: without linear part, and for the parent the other way round. */
    private void oppose(double[] turns, double[] opposite) {
        for (int row = firstRow + 3; row < firstRow + 6; row++) {
            int at = 6 * row;
            ConstraintRows.setLinear(turns, row, 0, 0, 0);
            ConstraintRows.setLinear(opposite, row, 0, 0, 0);
            ConstraintRows.setAngular(opposite, row, -turns[at + 3], -turns[at + 4], -turns[at + 5]);
        }
    }

    /**
     * Pushes back from a stop.
     *
     * @param overshoot how far the angle is beyond the stop, with its sign
     * @param inwards 1 at the lower stop, -1 at the upper one
     */
    private void stop(ConstraintRows rows, double rate, double overshoot, int inwards) {
        int row = firstRow + 5;
        turnByMotor(rows.first, inwards);
        double wanted = -rate * definition.stopErrorReduction() * overshoot;
        double opening = openingSpeed(rows.first);
        double thrown = -definition.stopBounce() * opening;
        boolean hits = opening * inwards < 0;
        rows.wanted[row] = hits && thrown * inwards > wanted * inwards ? thrown : wanted;
        rows.lower[row] = inwards > 0 ? 0 : Double.NEGATIVE_INFINITY;
        rows.upper[row] = inwards > 0 ? Double.POSITIVE_INFINITY : 0;
    }

    /** The row belongs to the stop now, so the motor acts as a plain torque; away from the stop, a weak one. */
    private void turnByMotor(double[] jacobian, int inwards) {
        boolean forwards = speed > 0 || (speed == 0 && inwards < 0);
        double torque = forwards ? definition.maxTorque() : -definition.maxTorque();
        if (speed * inwards > 0) {
            torque *= definition.fudgeFactor();
        }
        int axis = axisAt();
        for (int i = 0; i < 3; i++) {
            child.force[3 + i] += torque * jacobian[axis + i];
            parent.force[3 + i] -= torque * jacobian[axis + i];
        }
    }

    private double openingSpeed(double[] jacobian) {
        int axis = axisAt();
        return Rotations.dot(child.velocity, 3, jacobian, axis) - Rotations.dot(parent.velocity, 3, jacobian, axis);
    }

    @Override
    public void save(StateWriter out) {
        out.putDouble(speed);
    }

    @Override
    public void restore(StateReader in) {
        speed = in.getDouble();
    }
}
