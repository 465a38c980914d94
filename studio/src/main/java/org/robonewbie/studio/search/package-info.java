/** The page on which a search for better numbers is watched. {@link org.robonewbie.studio.search.SearchBoard} first. */
@NullMarked
package org.robonewbie.studio.search;

import org.jspecify.annotations.NullMarked;
