/**
 * The server side of the motion editor: files below one folder, and a robot in a world of its own that tries a motion. Read
 * {@link org.robonewbie.studio.motion.MotionApi} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.motion;
