/**
 * Measures how closely this simulator follows a real rcssserver3d: recordings of the original are replayed command by
 * command, and every row is compared. Read {@link org.robonewbie.workshop.fidelity.FidelityBench} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.workshop.fidelity;
