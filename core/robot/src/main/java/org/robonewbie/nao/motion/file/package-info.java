/**
 * Storage of motion files in folders and on the class path. Read {@link org.robonewbie.nao.motion.file.MotionFiles} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.nao.motion.file;
