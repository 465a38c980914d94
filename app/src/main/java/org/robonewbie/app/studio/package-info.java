/**
 * What commands show in the browser: a file, a search, the exercises. Read {@link org.robonewbie.app.studio.OpenedFile} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.app.studio;
