package org.robonewbie.studio.search;

/**
 * What is searched for.
 *
 * @param subject what shall become better, such as {@code kick-right}
 * @param objective at what, such as {@code kick-distance}
 * @param unit the unit of the objective
 * @param isLargerBetter whether larger values are better
 * @param rounds how many rounds there will be
 * @param method in words how it is gone about
 */
public record SearchTask(
        String subject, String objective, String unit, boolean isLargerBetter, int rounds, String method) {}
