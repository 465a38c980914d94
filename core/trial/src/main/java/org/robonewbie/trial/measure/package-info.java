/**
 * The measures of the framework, such as walking distance, kick distance and tilt. Read {@link
 * org.robonewbie.trial.measure.MeasureFromStart} first, the base class of most; {@link org.robonewbie.trial.measure.Measures}
 * finds them by name.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.trial.measure;
