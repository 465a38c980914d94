package org.robonewbie.agent.localisation;

import java.util.Optional;

/**
 * How sure a robot is of some numbers that it cannot read anywhere, and what it learns about all of them from one number that it
 * can read: the arithmetic of a Kalman filter (S. Thrun, W. Burgard, D. Fox, <em>Probabilistic Robotics</em>, 2005, chapter 3). What it
 * keeps is the covariance of the errors: on its diagonal the square of each standard deviation, beside it how errors hang together.
 */
final class Uncertainty {

    private final int size;
    private final double[][] covariance;

    /** Creates perfect certainty about some numbers. */
    Uncertainty(int size) {
        this.size = size;
        covariance = new double[size][size];
    }

    /** Adds an error that has nothing to do with those of before. */
    void doubt(int number, double deviation) {
        covariance[number][number] += deviation * deviation;
    }

    /** Has a new value of a number, whose error has nothing to do with those of before. */
    void forget(int number, double deviation) {
        for (int i = 0; i < size; i++) {
            covariance[number][i] = 0;
            covariance[i][number] = 0;
        }
        doubt(number, deviation);
    }

    /** A share of one number is added to another one, and so is a share of its error. */
    void add(int to, int from, double share) {
        for (int i = 0; i < size; i++) {
            covariance[to][i] += share * covariance[from][i];
        }
        for (int i = 0; i < size; i++) {
            covariance[i][to] += share * covariance[i][from];
        }
    }

    /**
     * Learns from something that was measured.
     *
     * @param gradient by how much the measured number grows with each of the unknown ones
     * @param difference by how much it is larger than expected
     * @param deviation its own standard deviation
     * @param mostDeviations a difference beyond that many standard deviations is taken for a mistake
     * @return what to add to the unknown numbers; nothing, if it was a mistake
     */
    Optional<double[]> learn(double[] gradient, double difference, double deviation, double mostDeviations) {
        double[] shares = new double[size];
        double variance = deviation * deviation;
        for (int i = 0; i < size; i++) {
            for (int j = 0; j < size; j++) {
                shares[i] += covariance[i][j] * gradient[j];
            }
            variance += gradient[i] * shares[i];
        }
        if (difference * difference > mostDeviations * mostDeviations * variance) {
            return Optional.empty();
        }
        double[] corrections = new double[size];
        for (int i = 0; i < size; i++) {
            corrections[i] = shares[i] / variance * difference;
            for (int j = 0; j < size; j++) {
                covariance[i][j] -= shares[i] * shares[j] / variance;
            }
        }
        return Optional.of(corrections);
    }
}
