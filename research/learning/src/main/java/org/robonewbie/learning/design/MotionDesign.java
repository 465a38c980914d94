package org.robonewbie.learning.design;

import java.util.List;
import org.robonewbie.learning.search.CostFunction;
import org.robonewbie.learning.search.SearchPlan;

/**
 * A motion, or some that belong together, as coordinates that can be searched for. {@link MotionWorkshop} runs the search and
 * writes the files.
 */
public interface MotionDesign extends CostFunction {

    /** {@return the first guess: the coordinates from which the search starts} */
    double[] start();

    /** {@return the plan with which the shipped motion was searched for} */
    SearchPlan plan();

    /**
     * Creates the motions that belong to coordinates.
     *
     * @param coordinates any coordinates
     * @return the motions with what their files say about them
     */
    List<DescribedMotion> motions(double[] coordinates);
}
