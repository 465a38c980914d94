/**
 * Scripted trials of motions and walks. Read {@link org.robonewbie.learning.motion.MotionTrial} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.learning.motion;
