/**
 * What robots are measured by, each thing once: how far they walk, how far they kick, how upright they stay. Read {@link
 * org.robonewbie.trial.measure.MeasureFromStart} first, which most of them extend; {@link
 * org.robonewbie.trial.measure.Measures} finds them by name.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.trial.measure;
