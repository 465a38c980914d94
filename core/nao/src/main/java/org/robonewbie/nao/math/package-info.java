/**
 * Mathematics that gives the same bits on each processor, JVM and browser. Read {@link
 * org.robonewbie.nao.math.PortableMath} first; its neighbours hold the formulas.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.nao.math;
