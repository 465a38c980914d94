package org.robonewbie.studio.search;

/**
 * Task of an optimisation.
 *
 * @param subject what is optimised, such as {@code kick-right}
 * @param objective the measure to improve, such as {@code kick-distance}
 * @param unit the unit of the objective
 * @param isLargerBetter whether larger values are better
 * @param rounds the number of rounds
 * @param method description of the method
 */
public record SearchTask(
        String subject, String objective, String unit, boolean isLargerBetter, int rounds, String method) {}
