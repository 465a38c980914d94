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

    private final Body child;
    private final Body parent;
    private final HingeDefinition definition;
    private final double[] anchorOnChild = new double[3];
    private final double[] anchorOnParent = new double[3];
    private final double[] axisOnChild = new double[3];
    private final double[] axisOnParent = new double[3];
    private final double[] startTurn = new double[4];
    private double speed;
    private double angle;
    private int childTurns = -1;
    private int parentTurns = -1;

    private final double[] relative = new double[4];
    private final double[] childArm = new double[3];
    private final double[] parentArm = new double[3];
    private final double[] axis = new double[3];
    private final double[] parentAxis = new double[3];
    private final double[] across = new double[3];
    private final double[] along = new double[3];

    HingeJoint(Body child, Body parent, HingeDefinition definition) {
        super(child, parent);
        this.child = child;
        this.parent = parent;
        this.definition = definition;
        fix(child, definition.anchor(), anchorOnChild);
        fix(parent, definition.anchor(), anchorOnParent);
        Vector3 direction = definition.axis().times(1 / definition.axis().length());
        Rotations.applyInverse(child.rotation, array(direction), axisOnChild);
        Rotations.applyInverse(parent.rotation, array(direction), axisOnParent);
        relativeTurn(startTurn);
    }

    private static void fix(Body body, Vector3 point, double[] local) {
        Rotations.applyInverse(body.rotation, array(point.minus(body.position())), local);
    }

    private static double[] array(Vector3 vector) {
        return new double[] {vector.x(), vector.y(), vector.z()};
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

    private double measureAngle() {
        double[] now = relative;
        relativeTurn(now);
        double[] start = startTurn;
        double w = now[0] * start[0] + now[1] * start[1] + now[2] * start[2] + now[3] * start[3];
        double x = -now[0] * start[1] + now[1] * start[0] - now[2] * start[3] + now[3] * start[2];
        double y = -now[0] * start[2] + now[2] * start[0] - now[3] * start[1] + now[1] * start[3];
        double z = -now[0] * start[3] + now[3] * start[0] - now[1] * start[2] + now[2] * start[1];
        double sine = Math.sqrt(x * x + y * y + z * z);
        boolean forward = x * axisOnChild[0] + y * axisOnChild[1] + z * axisOnChild[2] >= 0;
        double turned = 2 * PortableMath.atan2(sine, forward ? w : -w);
        return -(turned > Math.PI ? turned - 2 * Math.PI : turned);
    }

    /** The parent's orientation seen from the child: conjugate(child) · parent. */
    private void relativeTurn(double[] to) {
        double[] a = child.orientation();
        double[] b = parent.orientation();
        to[0] = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
        to[1] = a[0] * b[1] - a[1] * b[0] - a[2] * b[3] + a[3] * b[2];
        to[2] = a[0] * b[2] - a[2] * b[0] - a[3] * b[1] + a[1] * b[3];
        to[3] = a[0] * b[3] - a[3] * b[0] - a[1] * b[2] + a[2] * b[1];
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
        ConstraintRows.setAngular(rows.first, row, axis[0], axis[1], axis[2]);
        ConstraintRows.setAngular(rows.second, row, -axis[0], -axis[1], -axis[2]);
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
        Rotations.apply(child.rotation, anchorOnChild, childArm);
        Rotations.apply(parent.rotation, anchorOnParent, parentArm);
        crossRows(rows.first, childArm, 1);
        crossRows(rows.second, parentArm, -1);
        double pull = rate * PhysicsConstants.ERROR_REDUCTION;
        for (int i = 0; i < 3; i++) {
            rows.wanted[firstRow + i] = pull * (parentArm[i] + parent.place()[i] - childArm[i] - child.place()[i]);
        }
    }

    /** The velocity of a point on a body is v + w × arm; one row for each direction. */
    private void crossRows(double[] jacobian, double[] arm, double sign) {
        double x = sign * arm[0];
        double y = sign * arm[1];
        double z = sign * arm[2];
        ConstraintRows.setLinear(jacobian, firstRow, sign, 0, 0);
        ConstraintRows.setLinear(jacobian, firstRow + 1, 0, sign, 0);
        ConstraintRows.setLinear(jacobian, firstRow + 2, 0, 0, sign);
        ConstraintRows.setAngular(jacobian, firstRow, 0, z, -y);
        ConstraintRows.setAngular(jacobian, firstRow + 1, -z, 0, x);
        ConstraintRows.setAngular(jacobian, firstRow + 2, y, -x, 0);
    }

    private void holdAxes(ConstraintRows rows, double rate) {
        Rotations.apply(child.rotation, axisOnChild, axis);
        Rotations.apply(parent.rotation, axisOnParent, parentAxis);
        Rotations.squareTo(axis, across, along);
        double x = axis[1] * parentAxis[2] - axis[2] * parentAxis[1];
        double y = axis[2] * parentAxis[0] - axis[0] * parentAxis[2];
        double z = axis[0] * parentAxis[1] - axis[1] * parentAxis[0];
        double pull = rate * PhysicsConstants.ERROR_REDUCTION;
        holdAxis(rows, firstRow + 3, across, pull * (x * across[0] + y * across[1] + z * across[2]));
        holdAxis(rows, firstRow + 4, along, pull * (x * along[0] + y * along[1] + z * along[2]));
    }

    private static void holdAxis(ConstraintRows rows, int row, double[] direction, double wanted) {
        ConstraintRows.setAngular(rows.first, row, direction[0], direction[1], direction[2]);
        ConstraintRows.setAngular(rows.second, row, -direction[0], -direction[1], -direction[2]);
        rows.wanted[row] = wanted;
    }

    /**
     * Pushes back from a stop.
     *
     * @param overshoot how far the angle is beyond the stop, with its sign
     * @param inwards 1 at the lower stop, -1 at the upper one
     */
    private void stop(ConstraintRows rows, double rate, double overshoot, int inwards) {
        int row = firstRow + 5;
        turnByMotor(inwards);
        double wanted = -rate * definition.stopErrorReduction() * overshoot;
        double thrown = -definition.stopBounce() * openingSpeed();
        boolean hits = openingSpeed() * inwards < 0;
        rows.wanted[row] = hits && thrown * inwards > wanted * inwards ? thrown : wanted;
        rows.lower[row] = inwards > 0 ? 0 : Double.NEGATIVE_INFINITY;
        rows.upper[row] = inwards > 0 ? Double.POSITIVE_INFINITY : 0;
    }

    /** The row belongs to the stop now, so the motor acts as a plain torque; away from the stop, a weak one. */
    private void turnByMotor(int inwards) {
        boolean forwards = speed > 0 || (speed == 0 && inwards < 0);
        double torque = forwards ? definition.maxTorque() : -definition.maxTorque();
        if (speed * inwards > 0) {
            torque *= definition.fudgeFactor();
        }
        for (int i = 0; i < 3; i++) {
            child.force[3 + i] += torque * axis[i];
            parent.force[3 + i] -= torque * axis[i];
        }
    }

    private double openingSpeed() {
        return Rotations.dot(child.velocity, 3, axis, 0) - Rotations.dot(parent.velocity, 3, axis, 0);
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
