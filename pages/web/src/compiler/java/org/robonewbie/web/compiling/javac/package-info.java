/**
 * TeaVM rules for compiling {@code javac} to WebAssembly; not part of the compiled module.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.web.compiling.javac;
