/**
 * Server side of the motion editor: files below one folder, and a separate world in which motions are tried out. Start with
 * {@link org.robonewbie.studio.motion.MotionApi}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.motion;
