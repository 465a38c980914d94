/**
 * Progress page of an optimisation. Start with {@link org.robonewbie.studio.search.SearchFeed}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.search;
