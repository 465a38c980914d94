package org.robonewbie.simulator.sensing;

import java.util.function.UnaryOperator;

/** Fits a model to measurements by the method of Gauss and Newton with numerical derivatives. */
final class LeastSquares {

    private static final int ROUNDS = 20;
    private static final double STEP = 1e-6;

    private LeastSquares() {}

    /**
     * Finds the parameters for which the sum of squares of all residuals is least.
     *
     * @param start a guess
     * @param residuals what is left over, each divided by its standard error
     * @return the parameters
     */
    static double[] fit(double[] start, UnaryOperator<double[]> residuals) {
        double[] parameters = start.clone();
        for (int round = 0; round < ROUNDS; round++) {
            double[] rest = residuals.apply(parameters);
            double[][] derivatives = new double[parameters.length][];
            for (int i = 0; i < parameters.length; i++) {
                double[] moved = parameters.clone();
                moved[i] += STEP;
                derivatives[i] = residuals.apply(moved);
                for (int k = 0; k < rest.length; k++) {
                    derivatives[i][k] = (derivatives[i][k] - rest[k]) / STEP;
                }
            }
            double[] change = solveNormalEquations(derivatives, rest);
            for (int i = 0; i < parameters.length; i++) {
                parameters[i] -= change[i];
            }
        }
        return parameters;
    }

    /** Adds up the squares. */
    static double chiSquare(double[] residuals) {
        double sum = 0;
        for (double residual : residuals) {
            sum += residual * residual;
        }
        return sum;
    }

    private static double[] solveNormalEquations(double[][] derivatives, double[] rest) {
        int n = derivatives.length;
        double[][] rows = new double[n][n + 1];
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                rows[i][j] = dot(derivatives[i], derivatives[j]);
            }
            rows[i][n] = dot(derivatives[i], rest);
        }
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                double factor = j == i ? 0 : rows[j][i] / rows[i][i];
                for (int k = i; k <= n; k++) {
                    rows[j][k] -= factor * rows[i][k];
                }
            }
        }
        double[] solution = new double[n];
        for (int i = 0; i < n; i++) {
            solution[i] = rows[i][n] / rows[i][i];
        }
        return solution;
    }

    private static double dot(double[] one, double[] two) {
        double sum = 0;
        for (int i = 0; i < one.length; i++) {
            sum += one[i] * two[i];
        }
        return sum;
    }
}
