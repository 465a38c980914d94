/**
 * Stands in for {@code java.util} where the class library of the compiled program has a gap.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.web.library.java.util;
