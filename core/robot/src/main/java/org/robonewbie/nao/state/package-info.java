/**
 * Serialization of state. Everything that changes over time can be saved to a
 * {@link org.robonewbie.nao.state.StateWriter} and restored, bit for bit, from a
 * {@link org.robonewbie.nao.state.StateReader}. Read {@link org.robonewbie.nao.state.Restorable} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.nao.state;
