package org.robonewbie.simulator.physics.sparse;

import java.util.Arrays;

/**
 * The matrix A of an island in blocks, and its Cholesky factor L with A = L Lᵀ.
 *
 * <p>Only free rows take part: a row at its limit is replaced by one of the unit matrix. Columns are computed from left to
 * right, each from its own blocks of A and the finished columns that reach into it; when some rows change their state, only the
 * columns that depend on them are recomputed.
 */
final class BlockCholesky {

    private EliminationPlan plan = new EliminationPlan();
    private final ScratchCapacity capacity = new ScratchCapacity(1 << 14);
    private double[] matrix = {};
    private double[] factor = {};
    private double[] inverseDiagonal = {};
    private boolean[] changed = {};

    /** Builds the matrix: J M⁻¹ Jᵀ and the softness on the diagonal. */
    void assemble(EliminationPlan newPlan, ConstraintRows rows) {
        plan = newPlan;
        int length = capacity.fit(factor.length, plan.size());
        if (length != factor.length) {
            matrix = new double[length];
            factor = new double[length];
        }
        if (inverseDiagonal.length < plan.rows()) {
            inverseDiagonal = new double[2 * plan.rows()];
            changed = new boolean[inverseDiagonal.length];
        }
        Arrays.fill(matrix, 0, plan.size(), 0);
        int[] overlaps = plan.overlaps;
        for (int i = 0; i < plan.overlapsEnd; i += EliminationPlan.OVERLAP_NUMBERS) {
            double[] response = overlaps[i + 1] == 0 ? rows.firstResponse : rows.secondResponse;
            double[] jacobian = overlaps[i + 3] == 0 ? rows.first : rows.second;
            if (rows.hinge[overlaps[i + 2]]) {
                addOverlapOfHinge(overlaps[i], response, overlaps[i + 2], jacobian, overlaps[i + 4]);
            } else {
                addOverlap(overlaps[i], response, overlaps[i + 2], jacobian, overlaps[i + 4]);
            }
        }
        for (int k = 0; k < plan.joints(); k++) {
            int width = plan.rows(k);
            for (int r = 0; r < width; r++) {
                matrix[plan.diagonalOffset[k] + r * width + r] += rows.softness[plan.firstRow[k] + r];
            }
        }
        allRowsChanged();
    }

    /** Marks all rows as changed. */
    void allRowsChanged() {
        Arrays.fill(changed, 0, plan.joints(), true);
    }

    private void addOverlap(int column, double[] response, int row, double[] jacobian, int offset) {
        int width = plan.rows(column);
        int height = plan.rows(row);
        int columnStart = 6 * plan.firstRow[column];
        int rowStart = 6 * plan.firstRow[row];
        for (int r = 0; r < height; r++) {
            int a = rowStart + 6 * r;
            double j0 = jacobian[a];
            double j1 = jacobian[a + 1];
            double j2 = jacobian[a + 2];
            double j3 = jacobian[a + 3];
            double j4 = jacobian[a + 4];
            double j5 = jacobian[a + 5];
            int end = row == column ? r + 1 : width;
            int to = offset + r * width;
            for (int c = 0; c < end; c++) {
                int b = columnStart + 6 * c;
                matrix[to + c] += j0 * response[b]
                        + j1 * response[b + 1]
                        + j2 * response[b + 2]
                        + j3 * response[b + 3]
                        + j4 * response[b + 4]
                        + j5 * response[b + 5];
            }
        }
    }

    /**
     * The same where the rows are those of a hinge, without the half of the products that are zero. Of a diagonal block's upper half
     * nothing is used, so that it may hold anything.
     */
    private void addOverlapOfHinge(int column, double[] response, int row, double[] jacobian, int offset) {
        int width = plan.rows(column);
        HingeBlocks.addTimes(
                matrix,
                offset,
                width,
                row == column ? 3 : width,
                jacobian,
                6 * plan.firstRow[row],
                response,
                6 * plan.firstRow[column]);
    }

    /** Marks a row as changed, so that the joint's column is recomputed. */
    void rowChanged(int joint) {
        changed[joint] = true;
    }

    /**
     * Computes all columns that are not valid any more. A column changes with every earlier one that has a block in it; it is enough to
     * tell the first below a block, since that one has blocks at all others.
     */
    void factorise(byte[] state) {
        for (int k = 0; k < plan.joints(); k++) {
            if (changed[k]) {
                computeColumn(k, state);
                if (plan.belowStart[k] < plan.belowStart[k + 1]) {
                    changed[plan.below[plan.belowStart[k]]] = true;
                }
            }
        }
        Arrays.fill(changed, 0, plan.joints(), false);
    }

    private void computeColumn(int column, byte[] state) {
        int start = plan.diagonalOffset[column];
        int end = plan.diagonalOffset[column + 1];
        System.arraycopy(matrix, start, factor, start, end - start);
        int width = plan.rows(column);
        int[] updates = plan.updates;
        for (int i = plan.updatesStart[column];
                i < plan.updatesStart[column + 1];
                i += EliminationPlan.UPDATE_NUMBERS) {
            int inner = plan.rows(updates[i]);
            DenseBlocks.subtractProduct(
                    factor, updates[i + 1], updates[i + 2], updates[i + 3], updates[i + 4], width, inner);
        }
        int height = (end - start) / width;
        for (int c = 0; c < width; c++) {
            if (state[plan.firstRow[column] + c] != ConstraintRows.FREE) {
                DenseBlocks.replaceByUnit(factor, start, width, height, c);
            }
        }
        DenseBlocks.factorise(factor, start, width, height, inverseDiagonal, plan.firstRow[column]);
    }

    /**
     * Solves L Lᵀ x = b for the free rows.
     *
     * @param x holds b and receives the solution; at rows that are not free it is set to 0
     */
    void solve(double[] x, byte[] state) {
        for (int k = 0; k < plan.joints(); k++) {
            clearFixedRows(k, x, state);
            int at = plan.firstRow[k];
            int width = plan.rows(k);
            DenseBlocks.solveForwards(factor, plan.diagonalOffset[k], width, inverseDiagonal, x, at);
            int[] below = plan.below;
            for (int i = plan.belowStart[k]; i < plan.belowStart[k + 1]; i++) {
                DenseBlocks.subtractTimes(
                        factor, plan.belowOffset[i], plan.rows(below[i]), width, x, at, plan.firstRow[below[i]]);
            }
        }
        for (int k = plan.joints() - 1; k >= 0; k--) {
            int at = plan.firstRow[k];
            int width = plan.rows(k);
            int[] below = plan.below;
            for (int i = plan.belowStart[k]; i < plan.belowStart[k + 1]; i++) {
                DenseBlocks.subtractTransposedTimes(
                        factor, plan.belowOffset[i], plan.rows(below[i]), width, x, plan.firstRow[below[i]], at);
            }
            DenseBlocks.solveBackwards(factor, plan.diagonalOffset[k], width, inverseDiagonal, x, at);
        }
    }

    private void clearFixedRows(int joint, double[] x, byte[] state) {
        for (int row = plan.firstRow[joint]; row < plan.firstRow[joint + 1]; row++) {
            if (state[row] != ConstraintRows.FREE) {
                x[row] = 0;
            }
        }
    }
}
