/**
 * The measures of the framework, such as walking distance, kick distance and tilt. Read {@link
 * org.robonewbie.trial.measure.MeasureFromStart}, the base class of most measures, first. {@link
 * org.robonewbie.trial.measure.Measures} finds measures by name.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.trial.measure;
