/**
 * Keyframe motions: postures that a robot takes one after the other, and the text files that hold them. Read {@link
 * org.robonewbie.nao.motion.Motion} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.nao.motion;
