/**
 * Makes the documentation site from the Markdown pages of the project, while the project is built. Read {@link
 * org.robonewbie.site.SiteBuilder} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.site;
