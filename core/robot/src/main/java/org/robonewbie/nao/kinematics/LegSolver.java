package org.robonewbie.nao.kinematics;

import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.model.NaoModel;

/**
 * Levenberg-Marquardt solver with joint limits for the angles of one leg. It keeps the best result of all searches for the same
 * target.
 */
final class LegSolver {

    /** Position error in metres that counts as much as a rotation error of one radian. */
    private static final double ROTATION_WEIGHT = 0.2;

    private static final int JOINTS = LegChain.JOINTS;
    private static final int MAX_ITERATIONS = 60;
    private static final double GOOD_ENOUGH = 1e-18;
    private static final double FIRST_DAMPING = 1e-4;
    private static final double SMALLEST_DAMPING = 1e-12;
    private static final double MIN_IMPROVEMENT = 1e-9;
    private static final double TINY = 1e-12;
    private static final double LARGEST_DAMPING = 1e3;

    private final Leg leg;
    private final LegChain chain;
    private final double[] lower = new double[JOINTS];
    private final double[] upper = new double[JOINTS];
    private final double[] target = new double[3];
    private final double[] targetRotation = new double[9];
    private final double[] angles = new double[JOINTS];
    private final double[] best = new double[JOINTS];
    private double bestSquare;
    private double bestMetres;
    private double bestRotationDegrees;
    private final double[] trial = new double[JOINTS];
    private final double[] error = new double[JOINTS];
    private final double[] gradient = new double[JOINTS];
    private final double[][] columns = new double[JOINTS][JOINTS];
    private final double[][] normal = new double[JOINTS][JOINTS];
    private final double[][] factor = new double[JOINTS][JOINTS];
    private final double[] step = new double[JOINTS];

    LegSolver(NaoModel model, Leg leg) {
        this.leg = leg;
        chain = new LegChain(model, leg);
        for (int i = 0; i < JOINTS; i++) {
            Joint joint = leg.joints().get(i);
            lower[i] = PortableMath.toRadians(joint.minDegrees());
            upper[i] = PortableMath.toRadians(joint.maxDegrees());
        }
    }

    /** Searches from an initial posture. A result that is closer to the target than all earlier ones becomes the best result. */
    void solve(double[] startDegrees) {
        for (int i = 0; i < JOINTS; i++) {
            angles[i] = clamp(i, PortableMath.toRadians(startDegrees[i]));
        }
        double cost = evaluate(angles);
        linearise();
        double damping = FIRST_DAMPING;
        int iteration = 0;
        while (iteration < MAX_ITERATIONS && cost > GOOD_ENOUGH && damping < LARGEST_DAMPING) {
            iteration++;
            takeStep(damping);
            double trialCost = evaluate(trial);
            if (trialCost >= cost) {
                damping *= 10;
                continue;
            }
            boolean stagnates = trialCost > (1 - MIN_IMPROVEMENT) * cost;
            System.arraycopy(trial, 0, angles, 0, JOINTS);
            cost = trialCost;
            if (stagnates) {
                break;
            }
            linearise();
            damping = Math.max(SMALLEST_DAMPING, damping / 10);
        }
        double square = evaluate(angles);
        if (square < bestSquare) {
            bestSquare = square;
            bestMetres = length(0);
            bestRotationDegrees = PortableMath.toDegrees(length(3) / ROTATION_WEIGHT);
            System.arraycopy(angles, 0, best, 0, JOINTS);
        }
    }

    boolean isReached() {
        return LegSolution.isReached(bestMetres, bestRotationDegrees);
    }

    LegSolution best() {
        double[] degrees = new double[JOINTS];
        for (int i = 0; i < JOINTS; i++) {
            degrees[i] = leg.joints().get(i).clampDegrees(PortableMath.toDegrees(best[i]));
        }
        return new LegSolution(leg, degrees, bestMetres, bestRotationDegrees);
    }

    private double length(int from) {
        return Math.sqrt(
                error[from] * error[from] + error[from + 1] * error[from + 1] + error[from + 2] * error[from + 2]);
    }

    /** Sets a new target and discards the results of earlier searches. */
    void setTarget(CoordinateFrame foot) {
        bestSquare = Double.POSITIVE_INFINITY;
        target[0] = foot.origin().x();
        target[1] = foot.origin().y();
        target[2] = foot.origin().z();
        setTargetAxis(0, foot.forward());
        setTargetAxis(1, foot.left());
        setTargetAxis(2, foot.up());
    }

    private void setTargetAxis(int column, Vector3 axis) {
        targetRotation[column] = axis.x();
        targetRotation[3 + column] = axis.y();
        targetRotation[6 + column] = axis.z();
    }

    /** Sets the angles, calculates the error vector and returns its squared norm. */
    private double evaluate(double[] radians) {
        chain.update(radians);
        for (int k = 0; k < 3; k++) {
            error[k] = target[k] - chain.foot()[k];
        }
        evaluateRotation(chain.rotation());
        double square = 0;
        for (double component : error) {
            square += component * component;
        }
        return square;
    }

    /**
     * Calculates the remaining rotation as a rotation vector: its direction is the axis, and its length is the angle in
     * radians times the weight.
     */
    private void evaluateRotation(double[] rotation) {
        double x = (missing(rotation, 2, 1) - missing(rotation, 1, 2)) / 2;
        double y = (missing(rotation, 0, 2) - missing(rotation, 2, 0)) / 2;
        double z = (missing(rotation, 1, 0) - missing(rotation, 0, 1)) / 2;
        double cosine = (missing(rotation, 0, 0) + missing(rotation, 1, 1) + missing(rotation, 2, 2) - 1) / 2;
        double sine = Math.sqrt(x * x + y * y + z * z);
        double factor = sine > TINY ? PortableMath.atan2(sine, cosine) / sine : 1;
        error[3] = ROTATION_WEIGHT * factor * x;
        error[4] = ROTATION_WEIGHT * factor * y;
        error[5] = ROTATION_WEIGHT * factor * z;
        if (sine <= TINY && cosine < 0) {
            error[3] = ROTATION_WEIGHT * Math.PI;
        }
    }

    /** Returns an element of the remaining rotation: the target rotation times the inverse of the current one. */
    private double missing(double[] rotation, int row, int column) {
        return targetRotation[3 * row] * rotation[3 * column]
                + targetRotation[3 * row + 1] * rotation[3 * column + 1]
                + targetRotation[3 * row + 2] * rotation[3 * column + 2];
    }

    private void linearise() {
        for (int i = 0; i < JOINTS; i++) {
            chain.jacobianColumn(i, ROTATION_WEIGHT, columns[i]);
        }
        for (int i = 0; i < JOINTS; i++) {
            gradient[i] = dot(columns[i], error);
            for (int j = 0; j <= i; j++) {
                normal[i][j] = dot(columns[i], columns[j]);
            }
        }
    }

    private void takeStep(double damping) {
        for (int i = 0; i < JOINTS; i++) {
            boolean held = isHeld(i);
            step[i] = held ? 0 : gradient[i];
            for (int j = 0; j < i; j++) {
                factor[i][j] = held || isHeld(j) ? 0 : normal[i][j];
            }
            factor[i][i] = held ? 1 : normal[i][i] + damping;
        }
        solveByCholesky();
        for (int i = 0; i < JOINTS; i++) {
            trial[i] = clamp(i, angles[i] + step[i]);
        }
    }

    private boolean isHeld(int joint) {
        return (angles[joint] <= lower[joint] && gradient[joint] < 0)
                || (angles[joint] >= upper[joint] && gradient[joint] > 0);
    }

    /** Solves factor * x = step in place. The matrix is symmetric positive definite, given by its lower triangle. */
    private void solveByCholesky() {
        for (int i = 0; i < JOINTS; i++) {
            for (int j = 0; j <= i; j++) {
                double sum = factor[i][j];
                for (int k = 0; k < j; k++) {
                    sum -= factor[i][k] * factor[j][k];
                }
                factor[i][j] = i == j ? Math.sqrt(Math.max(sum, SMALLEST_DAMPING)) : sum / factor[j][j];
            }
            for (int k = 0; k < i; k++) {
                step[i] -= factor[i][k] * step[k];
            }
            step[i] /= factor[i][i];
        }
        for (int i = JOINTS - 1; i >= 0; i--) {
            for (int k = i + 1; k < JOINTS; k++) {
                step[i] -= factor[k][i] * step[k];
            }
            step[i] /= factor[i][i];
        }
    }

    private double clamp(int joint, double radians) {
        return Math.max(lower[joint], Math.min(upper[joint], radians));
    }

    private static double dot(double[] first, double[] second) {
        double sum = 0;
        for (int i = 0; i < JOINTS; i++) {
            sum += first[i] * second[i];
        }
        return sum;
    }
}
