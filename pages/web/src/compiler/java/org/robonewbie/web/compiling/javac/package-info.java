/**
 * What the compiler to WebAssembly has to know of {@code javac}; none of this is in the compiled program.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.web.compiling.javac;
