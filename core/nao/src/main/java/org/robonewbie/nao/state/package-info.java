/**
 * State as bytes: everything that changes over time writes itself to a {@link org.robonewbie.nao.state.StateWriter} and
 * reads itself back, bit by bit, from a {@link org.robonewbie.nao.state.StateReader}. Read {@link
 * org.robonewbie.nao.state.Restorable} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.nao.state;
