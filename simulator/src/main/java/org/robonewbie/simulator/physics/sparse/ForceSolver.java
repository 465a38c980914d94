package org.robonewbie.simulator.physics.sparse;

import java.util.List;

/**
 * Finds forces that satisfy every row or are at one of its limits: a linear complementarity problem.
 *
 * <p>Block principal pivoting: guess which rows are free, solve for their forces, and check which guesses were wrong: a free
 * row's force is beyond a limit, or a row at its limit would rather let go. All wrong guesses are changed at once; that nearly
 * always converges in one or two rounds. If it makes no progress for a while, only the last wrong guess is changed, which must
 * converge since A is positive definite (Murty's rule). Source: Júdice and Pires, "A block principal pivoting algorithm for
 * large-scale strictly monotone linear complementarity problems" (1994).
 */
final class ForceSolver {

    private static final int ROUNDS_WITHOUT_PROGRESS = 10;
    private static final int MOST_ROUNDS = 1000;
    private static final int FEWEST_ROUNDS = 40;
    private static final int MOST_ROUNDS_TIMES_ROWS = 200_000;
    private static final double FORCE_TOLERANCE = 1e-10;
    private static final double MOTION_TOLERANCE = 1e-9;

    private final ConstraintRows rows;
    private final BlockCholesky cholesky = new BlockCholesky();

    ForceSolver(ConstraintRows rows) {
        this.rows = rows;
    }

    /** Solves; afterwards the rows hold the forces and the bodies the accelerations that come from them. */
    void solve(EliminationPlan plan, List<ConstraintJoint> joints, List<Body> bodies) {
        cholesky.assemble(plan, rows);
        guess();
        int fewest = Integer.MAX_VALUE;
        int patience = ROUNDS_WITHOUT_PROGRESS;
        for (int round = mostRounds(); round > 0; round--) {
            computeForces(plan, joints, bodies);
            int wrong = countWrong(plan, joints);
            if (wrong == 0) {
                return;
            }
            if (wrong < fewest) {
                fewest = wrong;
                patience = ROUNDS_WITHOUT_PROGRESS;
            } else {
                patience--;
            }
            change(plan, patience < 0);
        }
    }

    /** Limits the time that a pile of interpenetrating robots, which no forces separate well, can take. */
    private int mostRounds() {
        int affordable = MOST_ROUNDS_TIMES_ROWS / Math.max(1, rows.count);
        return Math.max(FEWEST_ROUNDS, Math.min(MOST_ROUNDS, affordable));
    }

    /** A row that cannot push at all is at its limit for good; the others are free at first. */
    private void guess() {
        for (int row = 0; row < rows.count; row++) {
            rows.state[row] = rows.lower[row] < rows.upper[row] ? ConstraintRows.FREE : ConstraintRows.LOW;
        }
    }

    private void computeForces(EliminationPlan plan, List<ConstraintJoint> joints, List<Body> bodies) {
        cholesky.factorise(rows.state);
        boolean pushed = setLimits();
        if (pushed) {
            accelerate(joints, bodies);
            for (int k = 0; k < plan.joints(); k++) {
                ConstraintJoint joint = joints.get(plan.order[k]);
                for (int row = plan.firstRow[k]; row < plan.firstRow[k + 1]; row++) {
                    rows.solution[row] = -rows.excess(joint, row);
                }
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
        accelerate(joints, bodies);
    }

    /** Sets the forces of all rows at a limit and clears the others; returns whether any of them pushes. */
    private boolean setLimits() {
        boolean pushed = false;
        for (int row = 0; row < rows.count; row++) {
            rows.force[row] = switch (rows.state[row]) {
                case ConstraintRows.LOW -> rows.lower[row];
                case ConstraintRows.HIGH -> rows.upper[row];
                default -> 0;
            };
            pushed |= rows.force[row] != 0;
        }
        return pushed;
    }

    private void accelerate(List<ConstraintJoint> joints, List<Body> bodies) {
        for (int i = 0; i < bodies.size(); i++) {
            bodies.get(i).clearAcceleration();
        }
        for (int i = 0; i < joints.size(); i++) {
            rows.accelerate(joints.get(i));
        }
    }

    private int countWrong(EliminationPlan plan, List<ConstraintJoint> joints) {
        int wrong = 0;
        for (int k = 0; k < plan.joints(); k++) {
            ConstraintJoint joint = joints.get(plan.order[k]);
            for (int row = plan.firstRow[k]; row < plan.firstRow[k + 1]; row++) {
                rows.next[row] = nextState(joint, row);
                wrong += rows.next[row] == rows.state[row] ? 0 : 1;
            }
        }
        return wrong;
    }

    private byte nextState(ConstraintJoint joint, int row) {
        double force = rows.force[row];
        if (rows.state[row] == ConstraintRows.FREE) {
            if (force < rows.lower[row] - FORCE_TOLERANCE) {
                return ConstraintRows.LOW;
            }
            return force > rows.upper[row] + FORCE_TOLERANCE ? ConstraintRows.HIGH : ConstraintRows.FREE;
        }
        if (rows.lower[row] == rows.upper[row]) {
            return rows.state[row];
        }
        double excess = rows.excess(joint, row);
        boolean letsGo = rows.state[row] == ConstraintRows.LOW ? excess < -MOTION_TOLERANCE : excess > MOTION_TOLERANCE;
        return letsGo ? ConstraintRows.FREE : rows.state[row];
    }

    private void change(EliminationPlan plan, boolean onlyLast) {
        for (int k = plan.joints() - 1; k >= 0; k--) {
            for (int row = plan.firstRow[k + 1] - 1; row >= plan.firstRow[k]; row--) {
                if (rows.next[row] != rows.state[row]) {
                    rows.state[row] = rows.next[row];
                    cholesky.rowChanged(k);
                    if (onlyLast) {
                        return;
                    }
                }
            }
        }
    }
}
