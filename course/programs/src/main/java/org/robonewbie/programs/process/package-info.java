/**
 * Execution of programs in child processes with resource limits, in a {@link org.robonewbie.programs.process.Sandbox} if
 * one is available. Start with {@link org.robonewbie.programs.process.ChildProcess}, then read {@link
 * org.robonewbie.programs.process.ProgramMain}, the main class of these processes.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.programs.process;
