/**
 * Experiments: series of trials that a plan file defines and that run on any number of cores or computers with identical results. Read
 * {@link org.robonewbie.learning.series.Experiment} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.learning.series;
