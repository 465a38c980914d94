package org.robonewbie.nao.kinematics;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.model.Hinge;
import org.robonewbie.nao.model.Link;
import org.robonewbie.nao.model.NaoModel;

/**
 * The kinematic chain of six hinges from torso to foot, stored in arrays for fast repeated evaluation of the foot's
 * pose and Jacobian. Matrices are in row-major order.
 */
final class LegChain {

    static final int JOINTS = 6;

    private final double[] anchors = new double[3 * JOINTS];
    private final double[] axes = new double[3 * JOINTS];
    private final double[] footStart = new double[3];
    private final double[] rotation = new double[9];
    private final double[] turn = new double[9];
    private final double[] product = new double[9];
    private final double[] offset = new double[3];
    private final double[] worldAnchors = new double[3 * JOINTS];
    private final double[] worldAxes = new double[3 * JOINTS];
    private final double[] foot = new double[3];

    LegChain(NaoModel model, Leg leg) {
        for (int i = 0; i < JOINTS; i++) {
            Hinge hinge = model.hinges().get(model.hingeIndex(leg.joints().get(i)));
            put(anchors, i, SimSparkFrame.toBody(hinge.anchor()));
            put(axes, i, SimSparkFrame.toBody(hinge.axis()));
        }
        Link footLink = model.links().get(model.linkIndex(leg.footLink()));
        put(footStart, 0, SimSparkFrame.toBody(footLink.position()));
    }

    /** Sets the six joint angles in radians. */
    void update(double[] radians) {
        setIdentity();
        for (int i = 0; i < JOINTS; i++) {
            rotate(rotation, axes, 3 * i, worldAxes, 3 * i);
            rotate(rotation, anchors, 3 * i, worldAnchors, 3 * i);
            for (int k = 0; k < 3; k++) {
                worldAnchors[3 * i + k] += offset[k];
            }
            appendTurn(i, radians[i]);
            rotate(rotation, anchors, 3 * i, offset, 0);
            for (int k = 0; k < 3; k++) {
                offset[k] = worldAnchors[3 * i + k] - offset[k];
            }
        }
        rotate(rotation, footStart, 0, foot, 0);
        for (int k = 0; k < 3; k++) {
            foot[k] += offset[k];
        }
    }

    /** Returns the foot's position, valid until the next update. */
    double[] foot() {
        return foot;
    }

    /** Returns the foot's rotation matrix, valid until the next update. */
    double[] rotation() {
        return rotation;
    }

    /**
     * Fills one column of the Jacobian: the derivative of the foot's position (three rows, metres per radian) and of its
     * orientation (three rows, scaled by the weight) with respect to the joint angle.
     */
    void jacobianColumn(int joint, double rotationWeight, double[] column) {
        int at = 3 * joint;
        double armX = foot[0] - worldAnchors[at];
        double armY = foot[1] - worldAnchors[at + 1];
        double armZ = foot[2] - worldAnchors[at + 2];
        column[0] = worldAxes[at + 1] * armZ - worldAxes[at + 2] * armY;
        column[1] = worldAxes[at + 2] * armX - worldAxes[at] * armZ;
        column[2] = worldAxes[at] * armY - worldAxes[at + 1] * armX;
        for (int k = 0; k < 3; k++) {
            column[3 + k] = rotationWeight * worldAxes[at + k];
        }
    }

    private void setIdentity() {
        for (int i = 0; i < 9; i++) {
            rotation[i] = i % 4 == 0 ? 1 : 0;
        }
        offset[0] = 0;
        offset[1] = 0;
        offset[2] = 0;
    }

    /** Multiplies the rotation by the rotation of a joint (Rodrigues' formula). */
    private void appendTurn(int joint, double radians) {
        double sine = PortableMath.sin(radians);
        double cosine = PortableMath.cos(radians);
        double x = axes[3 * joint];
        double y = axes[3 * joint + 1];
        double z = axes[3 * joint + 2];
        double rest = 1 - cosine;
        turn[0] = cosine + rest * x * x;
        turn[1] = rest * x * y - sine * z;
        turn[2] = rest * x * z + sine * y;
        turn[3] = rest * y * x + sine * z;
        turn[4] = cosine + rest * y * y;
        turn[5] = rest * y * z - sine * x;
        turn[6] = rest * z * x - sine * y;
        turn[7] = rest * z * y + sine * x;
        turn[8] = cosine + rest * z * z;
        for (int row = 0; row < 3; row++) {
            for (int column = 0; column < 3; column++) {
                product[3 * row + column] = rotation[3 * row] * turn[column]
                        + rotation[3 * row + 1] * turn[3 + column]
                        + rotation[3 * row + 2] * turn[6 + column];
            }
        }
        System.arraycopy(product, 0, rotation, 0, 9);
    }

    private static void rotate(double[] matrix, double[] vectors, int from, double[] results, int to) {
        double x = vectors[from];
        double y = vectors[from + 1];
        double z = vectors[from + 2];
        for (int k = 0; k < 3; k++) {
            results[to + k] = matrix[3 * k] * x + matrix[3 * k + 1] * y + matrix[3 * k + 2] * z;
        }
    }

    private static void put(double[] vectors, int index, Vector3 vector) {
        vectors[3 * index] = vector.x();
        vectors[3 * index + 1] = vector.y();
        vectors[3 * index + 2] = vector.z();
    }
}
