/**
 * What commands show in the browser: a file, a search, the exercises. Start with {@link org.robonewbie.app.studio.OpenedFile}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.app.studio;
