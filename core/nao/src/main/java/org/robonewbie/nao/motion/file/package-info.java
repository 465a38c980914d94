/**
 * Where motion files come from and go to: folders and the class path. Read {@link
 * org.robonewbie.nao.motion.file.MotionFiles} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.nao.motion.file;
