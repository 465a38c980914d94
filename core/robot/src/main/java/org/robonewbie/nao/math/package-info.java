/**
 * Mathematical functions that yield the same bits on every processor, JVM and browser. Read {@link
 * org.robonewbie.nao.math.PortableMath} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.nao.math;
