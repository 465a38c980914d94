/**
 * Derivative-free optimisation by CMA-ES. Read {@link org.robonewbie.learning.search.CovarianceMatrixAdaptation} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.learning.search;
