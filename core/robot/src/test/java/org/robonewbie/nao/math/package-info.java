/** Tests of mathematics that is the same everywhere. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.nao.math;
