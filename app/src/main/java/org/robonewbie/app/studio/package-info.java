/**
 * What the commands show in the browser: an opened file, a search, a contest, the exercises. Start with {@link
 * org.robonewbie.app.studio.OpenedFile}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.app.studio;
