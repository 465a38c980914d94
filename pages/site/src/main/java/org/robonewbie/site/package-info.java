/**
 * Generates the documentation site from the Markdown pages during the build. Start with {@link org.robonewbie.site.SiteBuilder}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.site;
