/**
 * How well the shipped motions work, in numbers. Read {@link org.robonewbie.learning.measure.MotionMeasurement} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.learning.measure;
