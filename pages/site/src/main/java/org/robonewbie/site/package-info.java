/**
 * Makes the documentation site from the Markdown pages of the project, while the project is built. Read {@link
 * org.robonewbie.site.SiteBuilder} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.site;
