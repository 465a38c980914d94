/**
 * Finding, compiling and starting students' programs. Start with {@link org.robonewbie.programs.ProgramFinder}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.programs;
