package org.robonewbie.learning.search;

import java.util.List;

/** Black-box optimiser with the ask-and-tell interface: the caller evaluates the candidates. */
public interface AskAndTell {

    /**
     * Draws the candidates of the next generation.
     *
     * @return the points whose costs {@link #tell} expects
     */
    List<double[]> ask();

    /**
     * Updates the search with the costs of the last candidates.
     *
     * @param costs the cost of each candidate of {@link #ask}, in the same order; smaller is better, NaN is worst
     */
    void tell(double[] costs);

    /** {@return a copy of the current estimate of the optimum; the start point before the first {@link #tell}} */
    double[] mean();

    /** {@return the distribution of the next candidates} */
    CovarianceMatrixAdaptation distribution();
}
