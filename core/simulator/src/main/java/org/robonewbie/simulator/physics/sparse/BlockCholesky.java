package org.robonewbie.simulator.physics.sparse;

import java.util.Arrays;

/**
 * Left-looking block Cholesky factorization A = L Lᵀ of an island's system matrix.
 *
 * <p>Only free rows take part: a row at its limit is replaced by a row of the identity matrix. Each column is computed
 * from its own blocks of A and the earlier columns that update it. When the state of a row changes, only the columns that
 * depend on the row are recomputed.
 */
final class BlockCholesky {

    private SymbolicFactorization factorization = new SymbolicFactorization();
    private final ScratchCapacity capacity = new ScratchCapacity(1 << 14);
    private double[] matrix = {};
    private double[] factor = {};
    private double[] inverseDiagonal = {};
    private boolean[] changed = {};

    /** Assembles J M⁻¹ Jᵀ with the softness on the diagonal. */
    void assemble(SymbolicFactorization newFactorization, ConstraintRows rows) {
        factorization = newFactorization;
        int length = capacity.fit(factor.length, factorization.size());
        if (length != factor.length) {
            matrix = new double[length];
            factor = new double[length];
        }
        if (inverseDiagonal.length < factorization.rows()) {
            inverseDiagonal = new double[2 * factorization.rows()];
            changed = new boolean[inverseDiagonal.length];
        }
        Arrays.fill(matrix, 0, factorization.size(), 0);
        int[] overlaps = factorization.overlaps;
        for (int i = 0; i < factorization.overlapsEnd; i += SymbolicFactorization.INTS_PER_OVERLAP) {
            double[] response = overlaps[i + 1] == 0 ? rows.firstResponse : rows.secondResponse;
            double[] jacobian = overlaps[i + 3] == 0 ? rows.firstJacobian : rows.secondJacobian;
            if (rows.hinge[overlaps[i + 2]]) {
                addOverlapOfHinge(overlaps[i], response, overlaps[i + 2], jacobian, overlaps[i + 4]);
            } else {
                addOverlap(overlaps[i], response, overlaps[i + 2], jacobian, overlaps[i + 4]);
            }
        }
        for (int k = 0; k < factorization.joints(); k++) {
            int width = factorization.rows(k);
            for (int r = 0; r < width; r++) {
                matrix[factorization.diagonalOffset[k] + r * width + r] += rows.softness[factorization.firstRow[k] + r];
            }
        }
        allRowsChanged();
    }

    void allRowsChanged() {
        Arrays.fill(changed, 0, factorization.joints(), true);
    }

    private void addOverlap(int column, double[] response, int row, double[] jacobian, int offset) {
        int width = factorization.rows(column);
        int height = factorization.rows(row);
        int columnStart = 6 * factorization.firstRow[column];
        int rowStart = 6 * factorization.firstRow[row];
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

    /** Like {@link #addOverlap} for hinge rows, without the products that are zero. A diagonal block's upper half is undefined. */
    private void addOverlapOfHinge(int column, double[] response, int row, double[] jacobian, int offset) {
        int width = factorization.rows(column);
        HingeKernels.addTimes(
                matrix,
                offset,
                width,
                row == column ? 3 : width,
                jacobian,
                6 * factorization.firstRow[row],
                response,
                6 * factorization.firstRow[column]);
    }

    /** Marks a row of a joint as changed, so that the joint's column is recomputed. */
    void rowChanged(int joint) {
        changed[joint] = true;
    }

    /**
     * Recomputes the invalid columns. A column depends on every earlier column that has a block in its row. It is enough
     * to invalidate the column of the first block below the diagonal, because that column is the parent in the
     * elimination tree.
     */
    void factorise(byte[] state) {
        for (int k = 0; k < factorization.joints(); k++) {
            if (changed[k]) {
                computeColumn(k, state);
                if (factorization.belowStart[k] < factorization.belowStart[k + 1]) {
                    changed[factorization.below[factorization.belowStart[k]]] = true;
                }
            }
        }
        Arrays.fill(changed, 0, factorization.joints(), false);
    }

    private void computeColumn(int column, byte[] state) {
        int start = factorization.diagonalOffset[column];
        int end = factorization.diagonalOffset[column + 1];
        System.arraycopy(matrix, start, factor, start, end - start);
        int width = factorization.rows(column);
        int[] updates = factorization.updates;
        for (int i = factorization.updatesStart[column];
                i < factorization.updatesStart[column + 1];
                i += SymbolicFactorization.INTS_PER_UPDATE) {
            int inner = factorization.rows(updates[i]);
            BlockKernels.subtractProduct(
                    factor, updates[i + 1], updates[i + 2], updates[i + 3], updates[i + 4], width, inner);
        }
        int height = (end - start) / width;
        for (int c = 0; c < width; c++) {
            if (state[factorization.firstRow[column] + c] != ConstraintRows.FREE) {
                BlockKernels.replaceByUnit(factor, start, width, height, c);
            }
        }
        BlockKernels.factorise(factor, start, width, height, inverseDiagonal, factorization.firstRow[column]);
    }

    /**
     * Solves L Lᵀ x = b for the free rows.
     *
     * @param x b on entry, the solution on return; 0 at rows that are not free
     */
    void solve(double[] x, byte[] state) {
        for (int k = 0; k < factorization.joints(); k++) {
            clearFixedRows(k, x, state);
            int at = factorization.firstRow[k];
            int width = factorization.rows(k);
            BlockKernels.solveForwards(factor, factorization.diagonalOffset[k], width, inverseDiagonal, x, at);
            int[] below = factorization.below;
            for (int i = factorization.belowStart[k]; i < factorization.belowStart[k + 1]; i++) {
                BlockKernels.subtractTimes(
                        factor,
                        factorization.belowOffset[i],
                        factorization.rows(below[i]),
                        width,
                        x,
                        at,
                        factorization.firstRow[below[i]]);
            }
        }
        for (int k = factorization.joints() - 1; k >= 0; k--) {
            int at = factorization.firstRow[k];
            int width = factorization.rows(k);
            int[] below = factorization.below;
            for (int i = factorization.belowStart[k]; i < factorization.belowStart[k + 1]; i++) {
                BlockKernels.subtractTransposedTimes(
                        factor,
                        factorization.belowOffset[i],
                        factorization.rows(below[i]),
                        width,
                        x,
                        factorization.firstRow[below[i]],
                        at);
            }
            BlockKernels.solveBackwards(factor, factorization.diagonalOffset[k], width, inverseDiagonal, x, at);
        }
    }

    private void clearFixedRows(int joint, double[] x, byte[] state) {
        for (int row = factorization.firstRow[joint]; row < factorization.firstRow[joint + 1]; row++) {
            if (state[row] != ConstraintRows.FREE) {
                x[row] = 0;
            }
        }
    }
}
