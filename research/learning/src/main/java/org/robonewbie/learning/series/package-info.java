/**
 * Series of trials that are planned in a file and run on any number of cores or computers with the same table as the result.
 * Read {@link org.robonewbie.learning.series.Experiment} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.learning.series;
