/**
 * How well the shipped motions work, in numbers. Read {@link org.robonewbie.learning.measure.MotionMeasurement} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.learning.measure;
