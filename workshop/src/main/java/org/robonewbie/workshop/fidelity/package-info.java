/**
 * Fidelity bench: replays recordings of a real rcssserver3d command by command and compares every row. Start with {@link
 * org.robonewbie.workshop.fidelity.FidelityBench}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.workshop.fidelity;
