/**
 * Replacement for {@code org.slf4j}, whose search for implementations does not work in a page.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.web.library.org.slf4j;
