/**
 * The browser application: a web server on this computer only, and the live feed from the simulation to the pages. Read
 * {@link org.robonewbie.studio.StudioServer} first; the pages themselves are the files below {@code web}.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio;
