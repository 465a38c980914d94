/**
 * The browser application: a local web server, and the live feed from the simulation to the pages. Start with {@link
 * org.robonewbie.studio.StudioServer}; the pages are the files below {@code web}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio;
