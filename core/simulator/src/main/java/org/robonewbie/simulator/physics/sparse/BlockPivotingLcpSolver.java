package org.robonewbie.simulator.physics.sparse;

import java.util.Arrays;
import java.util.List;

/**
 * Block principal pivoting solver for the linear complementarity problem (LCP) of the constraint forces: every row is either
 * satisfied or has a force at its limit.
 *
 * <p>The solver starts from an initial basis of free rows, solves for their forces and looks for infeasible rows: a free row
 * whose force exceeds a limit, or a row at its limit whose residual has the wrong sign. All infeasible rows are pivoted
 * together, which nearly always converges in one or two iterations. When their number stops decreasing, only the last one is
 * pivoted (Murty's rule). This rule converges because the system matrix is positive definite, but may take many iterations.
 *
 * <p>Source: Júdice and Pires, "A block principal pivoting algorithm for large-scale strictly monotone linear complementarity
 * problems" (1994).
 */
final class BlockPivotingLcpSolver {

    private static final int MAX_PIVOTS_WITHOUT_PROGRESS = 10;
    private static final int MAX_ITERATIONS = 1000;
    private static final int MIN_ITERATIONS = 40;
    private static final int MAX_ITERATIONS_TIMES_ROWS = 200_000;
    private static final int MAX_WARM_START_ROWS = 250;
    private static final int MAX_WARM_START_ITERATIONS = 20;
    private static final double DEGENERACY_MARGIN = 1e-6;
    private static final double PIVOT_THRESHOLD = 0.5;
    private static final double MIN_LIMIT_SCALE = 1;
    private static final double FORCE_TOLERANCE = 1e-10;
    private static final double RESIDUAL_TOLERANCE = 1e-9;

    private final ConstraintRows rows;
    private final Accelerations accelerations;
    private final BlockCholesky cholesky = new BlockCholesky();
    /** Rows with a finite limit. */
    private int[] bounded = {};
    /** Elimination index of the joint of each bounded row. */
    private int[] columns = {};
    /** Island index of the joint of each bounded row. */
    private int[] boundedJoints = {};
    /** Infeasibility of each bounded row in newtons or m/s²; negative if the row is feasible. */
    private double[] infeasibility = {};

    private int boundedCount;

    BlockPivotingLcpSolver(ConstraintRows rows) {
        this.rows = rows;
        accelerations = new Accelerations(rows);
    }

    /** Solves the LCP and stores the forces in the rows and the resulting accelerations in the bodies. */
    void solve(SymbolicFactorization factorization, List<ConstraintJoint> joints, List<Body> bodies) {
        cholesky.assemble(factorization, rows);
        accelerations.begin(joints, bodies.size());
        findBoundedRows(factorization, joints);
        if (rows.count > MAX_WARM_START_ROWS || !solveFromWarmStart(factorization, joints)) {
            solveFromColdStart(factorization);
        }
        accelerations.selectAll(true);
        accelerations.sumAll();
        accelerations.writeTo(bodies);
    }

    /**
     * Starts from the basis of the previous step and pivots the most infeasible rows first, which takes fewer iterations. The
     * solution of the LCP is unique, so the forces do not depend on the pivoting order.
     *
     * @return whether the solver converged to a basis that rounding errors cannot change
     */
    private boolean solveFromWarmStart(SymbolicFactorization factorization, List<ConstraintJoint> joints) {
        setInitialBasis();
        for (int i = 0; i < joints.size(); i++) {
            joints.get(i).setInitialBasis(rows);
        }
        for (int iteration = MAX_WARM_START_ITERATIONS; iteration > 0; iteration--) {
            computeForces(factorization);
            if (countInfeasible() == 0) {
                return isNonDegenerate();
            }
            pivotMostInfeasible();
        }
        return false;
    }

    private boolean isNonDegenerate() {
        for (int i = 0; i < boundedCount; i++) {
            if (infeasibility[i] > -DEGENERACY_MARGIN) {
                return false;
            }
        }
        return true;
    }

    private void solveFromColdStart(SymbolicFactorization factorization) {
        cholesky.allRowsChanged();
        setInitialBasis();
        int fewest = Integer.MAX_VALUE;
        int pivotsLeft = MAX_PIVOTS_WITHOUT_PROGRESS;
        for (int iteration = maxIterations(); iteration > 0; iteration--) {
            computeForces(factorization);
            int infeasible = countInfeasible();
            if (infeasible == 0) {
                break;
            }
            if (infeasible < fewest) {
                fewest = infeasible;
                pivotsLeft = MAX_PIVOTS_WITHOUT_PROGRESS;
            } else {
                pivotsLeft--;
            }
            pivot(pivotsLeft < 0);
        }
    }

    /**
     * Returns the iteration limit, which bounds the time spent on interpenetrating robots: their LCP converges slowly.
     */
    private int maxIterations() {
        int affordable = MAX_ITERATIONS_TIMES_ROWS / Math.max(1, rows.count);
        return Math.max(MIN_ITERATIONS, Math.min(MAX_ITERATIONS, affordable));
    }

    /** Frees all rows except those whose lower and upper limits coincide. */
    private void setInitialBasis() {
        Arrays.fill(rows.state, 0, rows.count, ConstraintRows.FREE);
        for (int i = 0; i < boundedCount; i++) {
            if (!(rows.lower[bounded[i]] < rows.upper[bounded[i]])) {
                rows.state[bounded[i]] = ConstraintRows.LOW;
            }
        }
    }

    private void findBoundedRows(SymbolicFactorization factorization, List<ConstraintJoint> joints) {
        if (bounded.length < rows.count) {
            bounded = new int[rows.state.length];
            columns = new int[bounded.length];
            boundedJoints = new int[bounded.length];
            infeasibility = new double[bounded.length];
        }
        boundedCount = 0;
        for (int k = 0; k < factorization.joints(); k++) {
            ConstraintJoint joint = joints.get(factorization.order[k]);
            int end = factorization.firstRow[k + 1];
            for (int row = factorization.firstRow[k] + joint.firstBoundedRow();
                    row < end;
                    row += ConstraintJoint.BOUNDED_ROW_STRIDE) {
                if (rows.lower[row] != Double.NEGATIVE_INFINITY || rows.upper[row] != Double.POSITIVE_INFINITY) {
                    bounded[boundedCount] = row;
                    boundedJoints[boundedCount] = factorization.order[k];
                    columns[boundedCount++] = k;
                }
            }
        }
    }

    private void computeForces(SymbolicFactorization factorization) {
        cholesky.factorise(rows.state);
        if (applyLimitForces()) {
            accelerations.sumPushing();
            for (int k = 0; k < factorization.joints(); k++) {
                computeRightHandSide(factorization.order[k], factorization.firstRow[k], factorization.firstRow[k + 1]);
            }
        } else {
            System.arraycopy(rows.rightHandSide, 0, rows.solution, 0, rows.count);
        }
        cholesky.solve(rows.solution, rows.state);
        for (int row = 0; row < rows.count; row++) {
            if (rows.state[row] == ConstraintRows.FREE) {
                rows.force[row] = rows.solution[row];
            }
        }
    }

    /**
     * Computes the right-hand side of a joint's rows after subtracting the effect of forces at their limits. Bodies
     * without such forces are skipped.
     */
    private void computeRightHandSide(int joint, int from, int to) {
        boolean pushed = accelerations.isSelected(joint);
        for (int row = from; row < to; row++) {
            rows.solution[row] = pushed ? -accelerations.residual(joint, row) : -(0 - rows.rightHandSide[row]);
        }
    }

    /**
     * Sets the forces of rows at a limit, clears all others and selects the affected bodies; returns whether any body is
     * affected.
     */
    private boolean applyLimitForces() {
        Arrays.fill(rows.force, 0, rows.count, 0);
        accelerations.clearPushing();
        accelerations.selectAll(false);
        boolean pushed = false;
        for (int i = 0; i < boundedCount; i++) {
            int row = bounded[i];
            if (rows.state[row] != ConstraintRows.FREE) {
                rows.force[row] = rows.state[row] == ConstraintRows.LOW ? rows.lower[row] : rows.upper[row];
                if (rows.force[row] != 0) {
                    accelerations.markPushing(boundedJoints[i]);
                    pushed = true;
                }
            }
        }
        return pushed;
    }

    /** Counts the infeasible rows. Computes accelerations only for bodies with a row at its limit. */
    private int countInfeasible() {
        accelerations.selectAll(false);
        boolean any = false;
        for (int i = 0; i < boundedCount; i++) {
            if (rows.state[bounded[i]] != ConstraintRows.FREE) {
                accelerations.select(boundedJoints[i]);
                any = true;
            }
        }
        if (any) {
            accelerations.sumAll();
        }
        int infeasible = 0;
        for (int i = 0; i < boundedCount; i++) {
            int row = bounded[i];
            infeasibility[i] = infeasibility(boundedJoints[i], row);
            rows.nextState[row] = nextState(row, infeasibility[i]);
            infeasible += rows.nextState[row] == rows.state[row] ? 0 : 1;
        }
        return infeasible;
    }

    private double infeasibility(int joint, int row) {
        if (rows.state[row] == ConstraintRows.FREE) {
            return Math.max(rows.lower[row] - rows.force[row], rows.force[row] - rows.upper[row]);
        }
        if (rows.lower[row] == rows.upper[row]) {
            return Double.NEGATIVE_INFINITY;
        }
        double residual = accelerations.residual(joint, row);
        return rows.state[row] == ConstraintRows.LOW ? -residual : residual;
    }

    private byte nextState(int row, double infeasibility) {
        if (rows.state[row] != ConstraintRows.FREE) {
            return infeasibility > RESIDUAL_TOLERANCE ? ConstraintRows.FREE : rows.state[row];
        }
        if (rows.force[row] < rows.lower[row] - FORCE_TOLERANCE) {
            return ConstraintRows.LOW;
        }
        return rows.force[row] > rows.upper[row] + FORCE_TOLERANCE ? ConstraintRows.HIGH : ConstraintRows.FREE;
    }

    /**
     * Frees all infeasible rows at a limit, but moves a free row to its limit only if its violation is among the largest.
     */
    private void pivotMostInfeasible() {
        double most = 0;
        for (int i = 0; i < boundedCount; i++) {
            if (violatesLimit(bounded[i])) {
                most = Math.max(most, relativeViolation(i));
            }
        }
        for (int i = 0; i < boundedCount; i++) {
            int row = bounded[i];
            if (rows.nextState[row] != rows.state[row]
                    && !(violatesLimit(row) && relativeViolation(i) < PIVOT_THRESHOLD * most)) {
                rows.state[row] = rows.nextState[row];
                cholesky.rowChanged(columns[i]);
            }
        }
    }

    private boolean violatesLimit(int row) {
        return rows.state[row] == ConstraintRows.FREE && rows.nextState[row] != ConstraintRows.FREE;
    }

    private double relativeViolation(int index) {
        double limit = Math.min(Math.abs(rows.lower[bounded[index]]), Math.abs(rows.upper[bounded[index]]));
        return infeasibility[index] / Math.max(limit, MIN_LIMIT_SCALE);
    }

    private void pivot(boolean onlyLast) {
        for (int i = boundedCount - 1; i >= 0; i--) {
            int row = bounded[i];
            if (rows.nextState[row] != rows.state[row]) {
                rows.state[row] = rows.nextState[row];
                cholesky.rowChanged(columns[i]);
                if (onlyLast) {
                    return;
                }
            }
        }
    }
}
