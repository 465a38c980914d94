package org.robonewbie.simulator.physics.sparse;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.simulator.physics.HingeDefinition;
import org.robonewbie.simulator.physics.MotorHinge;

/**
 * Hinge joint with motor and stops, equivalent to ODE's ({@code joints/hinge.cpp}, {@code dxJointLimitMotor}).
 *
 * <p>It has six rows: three keep the anchors together, two align the axes, and the sixth is the motor, or a stop while the angle
 * is at or beyond the stop.
 */
final class HingeJoint extends ConstraintJoint implements MotorHinge, Restorable {

    private static final int ROWS = 6;
    private static final int ANCHOR_ON_CHILD = 0;
    private static final int ANCHOR_ON_PARENT = 3;
    private static final int AXIS_ON_CHILD = 6;
    private static final int AXIS_ON_PARENT = 9;
    private static final int INITIAL_ROTATION = 12;

    private final Body child;
    private final Body parent;
    private final HingeDefinition definition;
    /**
     * Anchors, axes and initial orientation in one array, to save space in the processor's cache, which hundreds of
     * robots may share.
     */
    private final double[] fixed = new double[16];

    private double maxTorque;
    private double motorSpeed;
    /** Motor torque that is applied as an external torque while the angle is at a stop. */
    private double appliedTorque;

    private double torque;
    private double angle;
    private int childVersion = -1;
    private int parentVersion = -1;

    HingeJoint(Body child, Body parent, HingeDefinition definition) {
        super(child, parent, true);
        this.child = child;
        this.parent = parent;
        this.definition = definition;
        this.maxTorque = definition.maxTorque();
        double[] anchor = {
            definition.anchor().x(),
            definition.anchor().y(),
            definition.anchor().z()
        };
        child.toLocal(anchor, fixed, ANCHOR_ON_CHILD);
        parent.toLocal(anchor, fixed, ANCHOR_ON_PARENT);
        Vector3 axis = definition.axis().times(1 / definition.axis().length());
        Rotations.applyInverse(child.rotation, axis.x(), axis.y(), axis.z(), fixed, AXIS_ON_CHILD);
        Rotations.applyInverse(parent.rotation, axis.x(), axis.y(), axis.z(), fixed, AXIS_ON_PARENT);
        storeInitialRotation();
    }

    /** Stores the orientation of the parent relative to the child: conjugate(child) · parent. */
    private void storeInitialRotation() {
        double[] a = child.orientation();
        double[] b = parent.orientation();
        fixed[INITIAL_ROTATION] = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
        fixed[INITIAL_ROTATION + 1] = a[0] * b[1] - a[1] * b[0] - a[2] * b[3] + a[3] * b[2];
        fixed[INITIAL_ROTATION + 2] = a[0] * b[2] - a[2] * b[0] - a[3] * b[1] + a[1] * b[3];
        fixed[INITIAL_ROTATION + 3] = a[0] * b[3] - a[3] * b[0] - a[1] * b[2] + a[2] * b[1];
    }

    @Override
    public void setSpeed(double radiansPerSecond) {
        motorSpeed = radiansPerSecond;
    }

    @Override
    public void setMaxTorque(double newtonMetres) {
        maxTorque = newtonMetres;
    }

    @Override
    public double torque() {
        return torque;
    }

    @Override
    public double radiansPerSecond() {
        double x = Rotations.dot(child.rotation, 0, fixed, AXIS_ON_CHILD);
        double y = Rotations.dot(child.rotation, 3, fixed, AXIS_ON_CHILD);
        double z = Rotations.dot(child.rotation, 6, fixed, AXIS_ON_CHILD);
        return Rotations.dot(x, y, z, child.velocity, 3) - Rotations.dot(x, y, z, parent.velocity, 3);
    }

    @Override
    public double angleRadians() {
        if (childVersion != child.rotationVersion() || parentVersion != parent.rotationVersion()) {
            angle = measureAngle();
            childVersion = child.rotationVersion();
            parentVersion = parent.rotationVersion();
        }
        return angle;
    }

    /** Returns the angle of the rotation from the initial to the current relative orientation. */
    private double measureAngle() {
        double[] a = child.orientation();
        double[] b = parent.orientation();
        double nowW = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
        double nowX = a[0] * b[1] - a[1] * b[0] - a[2] * b[3] + a[3] * b[2];
        double nowY = a[0] * b[2] - a[2] * b[0] - a[3] * b[1] + a[1] * b[3];
        double nowZ = a[0] * b[3] - a[3] * b[0] - a[1] * b[2] + a[2] * b[1];
        double startW = fixed[INITIAL_ROTATION];
        double startX = fixed[INITIAL_ROTATION + 1];
        double startY = fixed[INITIAL_ROTATION + 2];
        double startZ = fixed[INITIAL_ROTATION + 3];
        double w = nowW * startW + nowX * startX + nowY * startY + nowZ * startZ;
        double x = -nowW * startX + nowX * startW - nowY * startZ + nowZ * startY;
        double y = -nowW * startY + nowY * startW - nowZ * startX + nowX * startZ;
        double z = -nowW * startZ + nowZ * startW - nowX * startY + nowY * startX;
        double sine = Math.sqrt(x * x + y * y + z * z);
        boolean forward = Rotations.dot(x, y, z, fixed, AXIS_ON_CHILD) >= 0;
        double radians = 2 * PortableMath.atan2(sine, forward ? w : -w);
        return -(radians > Math.PI ? radians - 2 * Math.PI : radians);
    }

    @Override
    int rowCount() {
        return ROWS;
    }

    @Override
    void writeRows(ConstraintRows rows, double rate) {
        writeAnchorRows(rows, rate);
        writeAxisRows(rows, rate);
        int row = firstRow + 5;
        rows.softness[row] = HingeDefinition.SOFTNESS;
        double radians = angleRadians();
        if (radians <= definition.minRadians()) {
            writeStop(rows, rate, radians - definition.minRadians(), 1);
        } else if (radians >= definition.maxRadians()) {
            writeStop(rows, rate, radians - definition.maxRadians(), -1);
        } else {
            rows.rightHandSide[row] = motorSpeed;
            rows.lower[row] = -maxTorque;
            rows.upper[row] = maxTorque;
            appliedTorque = 0;
        }
    }

    private void writeAnchorRows(ConstraintRows rows, double rate) {
        double childX = Rotations.dot(child.rotation, 0, fixed, ANCHOR_ON_CHILD);
        double childY = Rotations.dot(child.rotation, 3, fixed, ANCHOR_ON_CHILD);
        double childZ = Rotations.dot(child.rotation, 6, fixed, ANCHOR_ON_CHILD);
        double parentX = Rotations.dot(parent.rotation, 0, fixed, ANCHOR_ON_PARENT);
        double parentY = Rotations.dot(parent.rotation, 3, fixed, ANCHOR_ON_PARENT);
        double parentZ = Rotations.dot(parent.rotation, 6, fixed, ANCHOR_ON_PARENT);
        writePointRows(rows.firstJacobian, 1, childX, childY, childZ);
        writePointRows(rows.secondJacobian, -1, -parentX, -parentY, -parentZ);
        double gain = rate * PhysicsConstants.ERROR_REDUCTION;
        double[] centre = child.centre();
        double[] parentCentre = parent.centre();
        rows.rightHandSide[firstRow] = gain * (parentX + parentCentre[0] - childX - centre[0]);
        rows.rightHandSide[firstRow + 1] = gain * (parentY + parentCentre[1] - childY - centre[1]);
        rows.rightHandSide[firstRow + 2] = gain * (parentZ + parentCentre[2] - childZ - centre[2]);
    }

    /** Writes a row per world axis for the velocity v + w × (x, y, z) of a point on a body. */
    private void writePointRows(double[] jacobian, double sign, double x, double y, double z) {
        ConstraintRows.setLinear(jacobian, firstRow, sign, 0, 0);
        ConstraintRows.setAngular(jacobian, firstRow, 0, z, -y);
        ConstraintRows.setLinear(jacobian, firstRow + 1, 0, sign, 0);
        ConstraintRows.setAngular(jacobian, firstRow + 1, -z, 0, x);
        ConstraintRows.setLinear(jacobian, firstRow + 2, 0, 0, sign);
        ConstraintRows.setAngular(jacobian, firstRow + 2, y, -x, 0);
    }

    /**
     * Writes the angular rows: the last one is about the axis of the child, the other two about axes perpendicular to
     * that axis.
     */
    private void writeAxisRows(ConstraintRows rows, double rate) {
        double x = Rotations.dot(child.rotation, 0, fixed, AXIS_ON_CHILD);
        double y = Rotations.dot(child.rotation, 3, fixed, AXIS_ON_CHILD);
        double z = Rotations.dot(child.rotation, 6, fixed, AXIS_ON_CHILD);
        double parentX = Rotations.dot(parent.rotation, 0, fixed, AXIS_ON_PARENT);
        double parentY = Rotations.dot(parent.rotation, 3, fixed, AXIS_ON_PARENT);
        double parentZ = Rotations.dot(parent.rotation, 6, fixed, AXIS_ON_PARENT);
        double[] jacobian = rows.firstJacobian;
        int axis = axisIndex();
        Rotations.set(jacobian, axis, x, y, z);
        Rotations.orthonormalBasis(jacobian, axis, axis - 12, axis - 6);
        completeAngularRows(jacobian, rows.secondJacobian);
        double errorX = y * parentZ - z * parentY;
        double errorY = z * parentX - x * parentZ;
        double errorZ = x * parentY - y * parentX;
        double gain = rate * PhysicsConstants.ERROR_REDUCTION;
        rows.rightHandSide[firstRow + 3] = gain * Rotations.dot(errorX, errorY, errorZ, jacobian, axis - 12);
        rows.rightHandSide[firstRow + 4] = gain * Rotations.dot(errorX, errorY, errorZ, jacobian, axis - 6);
    }

    /** Returns the index of the hinge axis in the Jacobian: the angular part of the last row. */
    private int axisIndex() {
        return 6 * (firstRow + 5) + 3;
    }

    /** Clears the linear parts of the angular rows and writes the parent's negated angular parts. */
    private void completeAngularRows(double[] jacobian, double[] opposite) {
        for (int row = firstRow + 3; row < firstRow + 6; row++) {
            int at = 6 * row;
            ConstraintRows.setLinear(jacobian, row, 0, 0, 0);
            ConstraintRows.setLinear(opposite, row, 0, 0, 0);
            ConstraintRows.setAngular(opposite, row, -jacobian[at + 3], -jacobian[at + 4], -jacobian[at + 5]);
        }
    }

    /**
     * Writes the row of a stop.
     *
     * @param overshoot signed angle beyond the stop in radians
     * @param inwards 1 at the lower stop, -1 at the upper stop
     */
    private void writeStop(ConstraintRows rows, double rate, double overshoot, int inwards) {
        int row = firstRow + 5;
        applyMotorTorque(rows.firstJacobian, inwards);
        double correction = -rate * HingeDefinition.STOP_ERROR_REDUCTION * overshoot;
        double speed = hingeSpeed(rows.firstJacobian);
        double rebound = -definition.stopBounce() * speed;
        boolean hits = speed * inwards < 0;
        rows.rightHandSide[row] = hits && rebound * inwards > correction * inwards ? rebound : correction;
        rows.lower[row] = inwards > 0 ? 0 : Double.NEGATIVE_INFINITY;
        rows.upper[row] = inwards > 0 ? Double.POSITIVE_INFINITY : 0;
    }

    /**
     * Applies the motor as an external torque, because the stop uses the motor's row. The torque is reduced if it
     * points away from the stop.
     */
    private void applyMotorTorque(double[] jacobian, int inwards) {
        boolean forwards = motorSpeed > 0 || (motorSpeed == 0 && inwards < 0);
        appliedTorque = forwards ? maxTorque : -maxTorque;
        if (motorSpeed * inwards > 0) {
            appliedTorque *= HingeDefinition.FUDGE_FACTOR;
        }
        int axis = axisIndex();
        for (int i = 0; i < 3; i++) {
            child.force[3 + i] += appliedTorque * jacobian[axis + i];
            parent.force[3 + i] -= appliedTorque * jacobian[axis + i];
        }
    }

    private double hingeSpeed(double[] jacobian) {
        int axis = axisIndex();
        return Rotations.dot(child.velocity, 3, jacobian, axis) - Rotations.dot(parent.velocity, 3, jacobian, axis);
    }

    @Override
    void readForces(ConstraintRows rows) {
        torque = rows.force[firstRow + 5] + appliedTorque;
    }

    @Override
    public void save(StateWriter out) {
        out.putDouble(motorSpeed);
    }

    @Override
    public void restore(StateReader in) {
        motorSpeed = in.getDouble();
    }
}
