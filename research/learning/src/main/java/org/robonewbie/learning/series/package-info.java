/**
 * Experiments: series of trials that are defined in a plan file and run on any number of cores or computers with identical results. Read
 * {@link org.robonewbie.learning.series.Experiment} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.learning.series;
