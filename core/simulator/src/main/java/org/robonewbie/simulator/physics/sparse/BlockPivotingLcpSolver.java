package org.robonewbie.simulator.physics.sparse;

import java.util.Arrays;
import java.util.List;

/**
 * Solves the linear complementarity problem of the constraint forces: each row is satisfied or its force is at a limit.
 *
 * <p>Block principal pivoting: start from an initial basis of free rows, solve for their forces, and find the infeasible rows:
 * a free row whose force is beyond a limit, or a row at its limit that separates. All of them are pivoted together; that nearly
 * always converges in one or two rounds. Without progress only the last infeasible row is pivoted (Murty's rule), which
 * converges because A is positive definite, given enough rounds. Source: Júdice and Pires, "A block principal pivoting algorithm for
 * large-scale strictly monotone linear complementarity problems" (1994).
 */
final class BlockPivotingLcpSolver {

    private static final int ROUNDS_WITHOUT_PROGRESS = 10;
    private static final int MAX_ROUNDS = 1000;
    private static final int MIN_ROUNDS = 40;
    private static final int MAX_ROUNDS_TIMES_ROWS = 200_000;
    private static final int MAX_ROWS_OF_A_ROBOT = 250;
    private static final int ROUNDS_NEARBY = 20;
    private static final double DOUBT = 1e-6;
    private static final double SMALL_SHARE = 0.5;
    private static final double MIN_LIMIT = 1;
    private static final double FORCE_TOLERANCE = 1e-10;
    private static final double MOTION_TOLERANCE = 1e-9;

    private final ConstraintRows rows;
    private final Accelerations accelerations;
    private final BlockCholesky cholesky = new BlockCholesky();
    private int[] limited = {};
    private int[] limitedJoint = {};
    /** Where those joints are in the island. */
    private int[] limitedBy = {};
    /** How far a limited row is beyond what its state allows, in newtons or m/s²; below 0 if it is feasible. */
    private double[] infeasibility = {};

    private int limits;

    BlockPivotingLcpSolver(ConstraintRows rows) {
        this.rows = rows;
        accelerations = new Accelerations(rows);
    }

    /** Solves; afterwards the rows hold the forces and the bodies the accelerations that come from them. */
    void solve(SymbolicFactorization factorization, List<ConstraintJoint> joints, List<Body> bodies) {
        cholesky.assemble(factorization, rows);
        accelerations.begin(joints, bodies.size());
        findLimits(factorization, joints);
        if (rows.count > MAX_ROWS_OF_A_ROBOT || !searchNearby(factorization, joints)) {
            search(factorization);
        }
        accelerations.watchAll(true);
        accelerations.addAll();
        accelerations.tell(bodies);
    }

    /**
     * Searches in fewer rounds: starts with the basis of the last step and pivots the most infeasible rows first. The solution is
     * unique, so the forces do not depend on the path.
     *
     * @return whether it converged with no row so close to another state that rounding could decide
     */
    private boolean searchNearby(SymbolicFactorization factorization, List<ConstraintJoint> joints) {
        setInitialBasis();
        for (int i = 0; i < joints.size(); i++) {
            joints.get(i).setInitialBasis(rows);
        }
        for (int round = ROUNDS_NEARBY; round > 0; round--) {
            computeForces(factorization);
            if (countInfeasible() == 0) {
                return isBeyondDoubt();
            }
            pivotMostInfeasible();
        }
        return false;
    }

    private boolean isBeyondDoubt() {
        for (int i = 0; i < limits; i++) {
            if (infeasibility[i] > -DOUBT) {
                return false;
            }
        }
        return true;
    }

    private void search(SymbolicFactorization factorization) {
        cholesky.allRowsChanged();
        setInitialBasis();
        int fewest = Integer.MAX_VALUE;
        int patience = ROUNDS_WITHOUT_PROGRESS;
        for (int round = mostRounds(); round > 0; round--) {
            computeForces(factorization);
            int infeasible = countInfeasible();
            if (infeasible == 0) {
                break;
            }
            if (infeasible < fewest) {
                fewest = infeasible;
                patience = ROUNDS_WITHOUT_PROGRESS;
            } else {
                patience--;
            }
            pivot(patience < 0);
        }
    }

    /** Limits the time that a pile of interpenetrating robots, which no forces separate well, can take. */
    private int mostRounds() {
        int affordable = MAX_ROUNDS_TIMES_ROWS / Math.max(1, rows.count);
        return Math.max(MIN_ROUNDS, Math.min(MAX_ROUNDS, affordable));
    }

    /** Sets all rows free except those that cannot push at all. */
    private void setInitialBasis() {
        Arrays.fill(rows.state, 0, rows.count, ConstraintRows.FREE);
        for (int i = 0; i < limits; i++) {
            if (!(rows.lower[limited[i]] < rows.upper[limited[i]])) {
                rows.state[limited[i]] = ConstraintRows.LOW;
            }
        }
    }

    /** Finds the rows with limits; all others stay free. */
    private void findLimits(SymbolicFactorization factorization, List<ConstraintJoint> joints) {
        if (limited.length < rows.count) {
            limited = new int[rows.state.length];
            limitedJoint = new int[limited.length];
            limitedBy = new int[limited.length];
            infeasibility = new double[limited.length];
        }
        limits = 0;
        for (int k = 0; k < factorization.joints(); k++) {
            ConstraintJoint joint = joints.get(factorization.order[k]);
            int end = factorization.firstRow[k + 1];
            for (int row = factorization.firstRow[k] + joint.firstLimit();
                    row < end;
                    row += ConstraintJoint.ROWS_PER_LIMIT) {
                if (rows.lower[row] != Double.NEGATIVE_INFINITY || rows.upper[row] != Double.POSITIVE_INFINITY) {
                    limited[limits] = row;
                    limitedBy[limits] = factorization.order[k];
                    limitedJoint[limits++] = k;
                }
            }
        }
    }

    private void computeForces(SymbolicFactorization factorization) {
        cholesky.factorise(rows.state);
        if (setLimits()) {
            accelerations.addPushes();
            for (int k = 0; k < factorization.joints(); k++) {
                demand(factorization.order[k], factorization.firstRow[k], factorization.firstRow[k + 1]);
            }
        } else {
            System.arraycopy(rows.wanted, 0, rows.solution, 0, rows.count);
        }
        cholesky.solve(rows.solution, rows.state);
        for (int row = 0; row < rows.count; row++) {
            if (rows.state[row] == ConstraintRows.FREE) {
                rows.force[row] = rows.solution[row];
            }
        }
    }

    /** What is left to the free rows of a joint when rows at their limits push. Bodies that are not pushed spare the sums. */
    private void demand(int joint, int from, int to) {
        boolean moved = accelerations.isWatched(joint);
        for (int row = from; row < to; row++) {
            rows.solution[row] = moved ? -accelerations.excess(joint, row) : -(0 - rows.wanted[row]);
        }
    }

    /** Sets the forces of all rows at a limit, clears the others, watches bodies that are pushed; returns whether any is. */
    private boolean setLimits() {
        Arrays.fill(rows.force, 0, rows.count, 0);
        accelerations.stopPushing();
        accelerations.watchAll(false);
        boolean pushed = false;
        for (int i = 0; i < limits; i++) {
            int row = limited[i];
            if (rows.state[row] != ConstraintRows.FREE) {
                rows.force[row] = rows.state[row] == ConstraintRows.LOW ? rows.lower[row] : rows.upper[row];
                if (rows.force[row] != 0) {
                    accelerations.push(limitedBy[i]);
                    pushed = true;
                }
            }
        }
        return pushed;
    }

    /** Only bodies that are held by a row at its limit need their accelerations for this. */
    private int countInfeasible() {
        accelerations.watchAll(false);
        boolean any = false;
        for (int i = 0; i < limits; i++) {
            if (rows.state[limited[i]] != ConstraintRows.FREE) {
                accelerations.watch(limitedBy[i]);
                any = true;
            }
        }
        if (any) {
            accelerations.addAll();
        }
        int infeasible = 0;
        for (int i = 0; i < limits; i++) {
            int row = limited[i];
            infeasibility[i] = infeasibility(limitedBy[i], row);
            rows.next[row] = nextState(row, infeasibility[i]);
            infeasible += rows.next[row] == rows.state[row] ? 0 : 1;
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
        double excess = accelerations.excess(joint, row);
        return rows.state[row] == ConstraintRows.LOW ? -excess : excess;
    }

    private byte nextState(int row, double infeasibility) {
        if (rows.state[row] != ConstraintRows.FREE) {
            return infeasibility > MOTION_TOLERANCE ? ConstraintRows.FREE : rows.state[row];
        }
        if (rows.force[row] < rows.lower[row] - FORCE_TOLERANCE) {
            return ConstraintRows.LOW;
        }
        return rows.force[row] > rows.upper[row] + FORCE_TOLERANCE ? ConstraintRows.HIGH : ConstraintRows.FREE;
    }

    /** Releases all rows that separate, but fixes at a limit only rows that are far beyond it. */
    private void pivotMostInfeasible() {
        double most = 0;
        for (int i = 0; i < limits; i++) {
            if (isBeyondLimit(limited[i])) {
                most = Math.max(most, urgency(i));
            }
        }
        for (int i = 0; i < limits; i++) {
            int row = limited[i];
            if (rows.next[row] != rows.state[row] && !(isBeyondLimit(row) && urgency(i) < SMALL_SHARE * most)) {
                rows.state[row] = rows.next[row];
                cholesky.rowChanged(limitedJoint[i]);
            }
        }
    }

    private boolean isBeyondLimit(int row) {
        return rows.state[row] == ConstraintRows.FREE && rows.next[row] != ConstraintRows.FREE;
    }

    private double urgency(int index) {
        double limit = Math.min(Math.abs(rows.lower[limited[index]]), Math.abs(rows.upper[limited[index]]));
        return infeasibility[index] / Math.max(limit, MIN_LIMIT);
    }

    private void pivot(boolean onlyLast) {
        for (int i = limits - 1; i >= 0; i--) {
            int row = limited[i];
            if (rows.next[row] != rows.state[row]) {
                rows.state[row] = rows.next[row];
                cholesky.rowChanged(limitedJoint[i]);
                if (onlyLast) {
                    return;
                }
            }
        }
    }
}
