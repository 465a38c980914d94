/**
 * Keyframe motions, their playback, and the text files that describe them. Read {@link org.robonewbie.nao.motion.Motion} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.nao.motion;
