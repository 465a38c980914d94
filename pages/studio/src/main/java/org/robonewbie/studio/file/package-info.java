/**
 * What holds for all files that pages may name. Read {@link org.robonewbie.studio.file.PageFolder} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.file;
