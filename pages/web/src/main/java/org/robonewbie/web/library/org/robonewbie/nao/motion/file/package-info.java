/**
 * What the page puts in the place of the package without {@code org.robonewbie.web.library} before its name.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.web.library.org.robonewbie.nao.motion.file;
