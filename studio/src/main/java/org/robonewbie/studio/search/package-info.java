/** The page on which a search for better numbers is watched. {@link org.robonewbie.studio.search.SearchBoard} first. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.search;
