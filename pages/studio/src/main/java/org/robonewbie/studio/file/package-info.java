/**
 * Access to the files that pages may read and write. Start with {@link org.robonewbie.studio.file.PageFolder}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.file;
