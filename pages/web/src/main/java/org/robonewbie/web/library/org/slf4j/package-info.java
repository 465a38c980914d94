/**
 * Replacement for {@code org.slf4j}, which cannot search for implementations in a page.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.web.library.org.slf4j;
