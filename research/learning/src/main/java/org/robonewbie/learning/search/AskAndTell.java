package org.robonewbie.learning.search;

import java.util.List;

/** A search that is asked for candidates and told what they cost, again and again, so that whoever asks decides how they are tried. */
public interface AskAndTell {

    /**
     * Draws the next candidates.
     *
     * @return points of which the costs are wanted by {@link #tell}
     */
    List<double[]> ask();

    /**
     * Learns from the costs of the last candidates.
     *
     * @param costs one cost for each candidate of {@link #ask}, in the same order; smaller is better, NaN is worst
     */
    void tell(double[] costs);

    /** {@return a copy of the answer so far; the start before the first {@link #tell}} */
    double[] mean();

    /** {@return the distribution from which the next candidates are drawn} */
    CovarianceMatrixAdaptation distribution();
}
