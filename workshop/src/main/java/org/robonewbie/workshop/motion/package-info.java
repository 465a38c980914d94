/**
 * Success rates of the shipped motions and walks. Start with {@link org.robonewbie.workshop.motion.MotionMeasurement}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.workshop.motion;
