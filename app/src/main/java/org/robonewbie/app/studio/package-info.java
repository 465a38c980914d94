/** What commands show in the browser: a file, a search, the exercises. Read {@link org.robonewbie.app.studio.OpenedFile} first. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.app.studio;
