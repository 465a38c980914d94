/**
 * Services behind the studio's pages. Start with {@link org.robonewbie.studio.service.PageService}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.service;
