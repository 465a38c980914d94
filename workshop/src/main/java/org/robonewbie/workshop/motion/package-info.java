/**
 * How well the shipped motions and walks work, in numbers. Read {@link org.robonewbie.workshop.motion.MotionMeasurement} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.workshop.motion;
