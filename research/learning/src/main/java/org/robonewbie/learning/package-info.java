/**
 * How the shipped motions were made and are measured: a robot in a world of its own plays motions exactly as an agent
 * would play them. Read {@link org.robonewbie.learning.search.CovarianceMatrixAdaptation} for the search behind it.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.learning;
