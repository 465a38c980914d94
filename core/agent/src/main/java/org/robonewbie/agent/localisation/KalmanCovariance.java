package org.robonewbie.agent.localisation;

import java.util.Optional;

/** Covariance matrix of a Kalman filter (S. Thrun, W. Burgard, D. Fox, <em>Probabilistic Robotics</em>, 2005, chapter 3). */
final class KalmanCovariance {

    private final int size;
    private final double[][] covariance;

    /** Creates a zero matrix. */
    KalmanCovariance(int size) {
        this.size = size;
        covariance = new double[size][size];
    }

    /** Adds independent noise to a state. */
    void addProcessNoise(int state, double deviation) {
        covariance[state][state] += deviation * deviation;
    }

    /** Sets the deviation of a state and removes its correlation with the other states. */
    void reset(int state, double deviation) {
        for (int i = 0; i < size; i++) {
            covariance[state][i] = 0;
            covariance[i][state] = 0;
        }
        addProcessNoise(state, deviation);
    }

    /** Propagates {@code x[to] += share · x[from]}. */
    void propagate(int to, int from, double share) {
        for (int i = 0; i < size; i++) {
            covariance[to][i] += share * covariance[from][i];
        }
        for (int i = 0; i < size; i++) {
            covariance[i][to] += share * covariance[i][from];
        }
    }

    /**
     * Corrects the covariance using a scalar measurement.
     *
     * @param gradient the derivatives of the measurement with respect to the states
     * @param innovation measured minus expected value
     * @param deviation standard deviation of the measurement
     * @param gateDeviations maximum innovation, in standard deviations of the innovation; larger ones are rejected
     * @return the gain times the innovation, to be added to the states; empty if the measurement is rejected
     */
    Optional<double[]> correct(double[] gradient, double innovation, double deviation, double gateDeviations) {
        double[] crossCovariance = new double[size];
        double variance = deviation * deviation;
        for (int i = 0; i < size; i++) {
            for (int j = 0; j < size; j++) {
                crossCovariance[i] += covariance[i][j] * gradient[j];
            }
            variance += gradient[i] * crossCovariance[i];
        }
        if (innovation * innovation > gateDeviations * gateDeviations * variance) {
            return Optional.empty();
        }
        double[] corrections = new double[size];
        for (int i = 0; i < size; i++) {
            corrections[i] = crossCovariance[i] / variance * innovation;
            for (int j = 0; j < size; j++) {
                covariance[i][j] -= crossCovariance[i] * crossCovariance[j] / variance;
            }
        }
        return Optional.of(corrections);
    }
}
