/**
 * Programs in the studio: pages write them, see the compiler's words while they type, and run them on the pitch. Read {@link
 * org.robonewbie.studio.program.CompilerService} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.program;
