package org.robonewbie.nao.state;

/**
 * An object whose state can be saved and restored bit for bit.
 *
 * <p>{@link #restore} reads what {@link #save} wrote, in the same order. A restored object behaves exactly as the
 * original would have after {@code save}. An agent whose class implements this interface is restored together with its
 * world if the simulator runs in the same process; other agents keep their current state.
 *
 * <pre>{@code
 * public void save(StateWriter out) { out.putInt(steps); }
 * public void restore(StateReader in) { steps = in.getInt(); }
 * }</pre>
 */
public interface Restorable {

    /**
     * Writes the state.
     *
     * @param out destination of the state
     */
    void save(StateWriter out);

    /**
     * Restores a saved state.
     *
     * @param in source of the state that {@link #save} wrote
     * @throws IllegalArgumentException if the bytes are not such a state; the object may then be partially restored
     */
    void restore(StateReader in);
}
