/**
 * The page on which a search for better numbers is watched. {@link org.robonewbie.studio.search.SearchFeed} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.search;
