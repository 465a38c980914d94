/**
 * Search for numbers that make a cost small, without derivatives. Read {@link
 * org.robonewbie.learning.search.CovarianceMatrixAdaptation} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.learning.search;
