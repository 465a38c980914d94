/** Files that are written as a whole: {@link org.robonewbie.nao.file.AtomicFile}. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.nao.file;
