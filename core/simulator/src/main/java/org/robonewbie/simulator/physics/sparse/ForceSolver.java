package org.robonewbie.simulator.physics.sparse;

import java.util.Arrays;
import java.util.List;

/**
 * Finds forces that satisfy every row or are at one of its limits: a linear complementarity problem.
 *
 * <p>Block principal pivoting: guess which rows are free, solve for their forces, and check which guesses were wrong: a free
 * row's force is beyond a limit, or a row at its limit would rather let go. All wrong guesses are changed at once; that nearly
 * always converges in one or two rounds. If it makes no progress for a while, only the last wrong guess is changed, which must
 * converge since A is positive definite (Murty's rule), if it is given enough rounds. Source: Júdice and Pires, "A block principal pivoting algorithm for
 * large-scale strictly monotone linear complementarity problems" (1994).
 */
final class ForceSolver {

    private static final int ROUNDS_WITHOUT_PROGRESS = 10;
    private static final int MOST_ROUNDS = 1000;
    private static final int FEWEST_ROUNDS = 40;
    private static final int MOST_ROUNDS_TIMES_ROWS = 200_000;
    private static final int MOST_ROWS_OF_A_ROBOT = 250;
    private static final int ROUNDS_NEARBY = 20;
    private static final double DOUBT = 1e-6;
    private static final double SMALL_SHARE = 0.5;
    private static final double LEAST_LIMIT = 1;
    private static final double FORCE_TOLERANCE = 1e-10;
    private static final double MOTION_TOLERANCE = 1e-9;

    private final ConstraintRows rows;
    private final Accelerations accelerations;
    private final BlockCholesky cholesky = new BlockCholesky();
    private int[] limited = {};
    private int[] limitedJoint = {};
    /** Where those joints are in the island. */
    private int[] limitedBy = {};
    /** How far a limited row is beyond what its state allows, in newtons or m/s²; below 0 if its state is right. */
    private double[] wrongness = {};

    private int limits;

    ForceSolver(ConstraintRows rows) {
        this.rows = rows;
        accelerations = new Accelerations(rows);
    }

    /** Solves; afterwards the rows hold the forces and the bodies the accelerations that come from them. */
    void solve(EliminationPlan plan, List<ConstraintJoint> joints, List<Body> bodies) {
        cholesky.assemble(plan, rows);
        accelerations.begin(joints, bodies.size());
        findLimits(plan, joints);
        if (rows.count > MOST_ROWS_OF_A_ROBOT || !searchNearby(plan, joints)) {
            search(plan);
        }
        accelerations.watchAll(true);
        accelerations.addAll();
        accelerations.tell(bodies);
    }

    /**
     * Looks for the forces in fewer rounds: begins with what touched the ground in the last step, and first changes what is most wrong,
     * which often mends the rest. There is just one solution, so that forces do not depend on the way to it.
     *
     * @return whether that went well and no row is so near to another state that rounding could decide
     */
    private boolean searchNearby(EliminationPlan plan, List<ConstraintJoint> joints) {
        guess();
        for (int i = 0; i < joints.size(); i++) {
            joints.get(i).guessStates(rows);
        }
        for (int round = ROUNDS_NEARBY; round > 0; round--) {
            computeForces(plan);
            if (countWrong() == 0) {
                return isBeyondDoubt();
            }
            changeMostWrong();
        }
        return false;
    }

    private boolean isBeyondDoubt() {
        for (int i = 0; i < limits; i++) {
            if (wrongness[i] > -DOUBT) {
                return false;
            }
        }
        return true;
    }

    private void search(EliminationPlan plan) {
        cholesky.allRowsChanged();
        guess();
        int fewest = Integer.MAX_VALUE;
        int patience = ROUNDS_WITHOUT_PROGRESS;
        for (int round = mostRounds(); round > 0; round--) {
            computeForces(plan);
            int wrong = countWrong();
            if (wrong == 0) {
                break;
            }
            if (wrong < fewest) {
                fewest = wrong;
                patience = ROUNDS_WITHOUT_PROGRESS;
            } else {
                patience--;
            }
            change(patience < 0);
        }
    }

    /** Limits the time that a pile of interpenetrating robots, which no forces separate well, can take. */
    private int mostRounds() {
        int affordable = MOST_ROUNDS_TIMES_ROWS / Math.max(1, rows.count);
        return Math.max(FEWEST_ROUNDS, Math.min(MOST_ROUNDS, affordable));
    }

    /** A row that cannot push at all is at its limit for good; the others are free at first. */
    private void guess() {
        Arrays.fill(rows.state, 0, rows.count, ConstraintRows.FREE);
        for (int i = 0; i < limits; i++) {
            if (!(rows.lower[limited[i]] < rows.upper[limited[i]])) {
                rows.state[limited[i]] = ConstraintRows.LOW;
            }
        }
    }

    /** Finds the rows whose state may change; those of the others are right from the beginning. */
    private void findLimits(EliminationPlan plan, List<ConstraintJoint> joints) {
        if (limited.length < rows.count) {
            limited = new int[rows.state.length];
            limitedJoint = new int[limited.length];
            limitedBy = new int[limited.length];
            wrongness = new double[limited.length];
        }
        limits = 0;
        for (int k = 0; k < plan.joints(); k++) {
            ConstraintJoint joint = joints.get(plan.order[k]);
            int end = plan.firstRow[k + 1];
            for (int row = plan.firstRow[k] + joint.firstLimit(); row < end; row += ConstraintJoint.ROWS_PER_LIMIT) {
                if (rows.lower[row] != Double.NEGATIVE_INFINITY || rows.upper[row] != Double.POSITIVE_INFINITY) {
                    limited[limits] = row;
                    limitedBy[limits] = plan.order[k];
                    limitedJoint[limits++] = k;
                }
            }
        }
    }

    private void computeForces(EliminationPlan plan) {
        cholesky.factorise(rows.state);
        if (setLimits()) {
            accelerations.addPushes();
            for (int k = 0; k < plan.joints(); k++) {
                demand(plan.order[k], plan.firstRow[k], plan.firstRow[k + 1]);
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
    private int countWrong() {
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
        int wrong = 0;
        for (int i = 0; i < limits; i++) {
            int row = limited[i];
            wrongness[i] = wrongness(limitedBy[i], row);
            rows.next[row] = nextState(row, wrongness[i]);
            wrong += rows.next[row] == rows.state[row] ? 0 : 1;
        }
        return wrong;
    }

    private double wrongness(int joint, int row) {
        if (rows.state[row] == ConstraintRows.FREE) {
            return Math.max(rows.lower[row] - rows.force[row], rows.force[row] - rows.upper[row]);
        }
        if (rows.lower[row] == rows.upper[row]) {
            return Double.NEGATIVE_INFINITY;
        }
        double excess = accelerations.excess(joint, row);
        return rows.state[row] == ConstraintRows.LOW ? -excess : excess;
    }

    private byte nextState(int row, double wrongness) {
        if (rows.state[row] != ConstraintRows.FREE) {
            return wrongness > MOTION_TOLERANCE ? ConstraintRows.FREE : rows.state[row];
        }
        if (rows.force[row] < rows.lower[row] - FORCE_TOLERANCE) {
            return ConstraintRows.LOW;
        }
        return rows.force[row] > rows.upper[row] + FORCE_TOLERANCE ? ConstraintRows.HIGH : ConstraintRows.FREE;
    }

    /** Lets go what wants to, but holds at a limit only rows that are far beyond it: contacts that would pull come before motors. */
    private void changeMostWrong() {
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
        return wrongness[index] / Math.max(limit, LEAST_LIMIT);
    }

    private void change(boolean onlyLast) {
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
