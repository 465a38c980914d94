/**
 * The studio's program editor: users edit programs, see diagnostics while typing, and run the programs on the pitch. Start
 * with {@link org.robonewbie.studio.program.CompilerService}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.program;
