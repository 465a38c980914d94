package org.robonewbie.nao.state;

/**
 * Something whose state can be saved and brought back to the bit.
 *
 * <p>What {@link #save} writes, {@link #restore} reads in the same order. Afterwards the object behaves exactly as it would
 * have behaved after {@code save}. An agent whose class implements it is restored together with the world that it
 * lives in, if the simulator runs in the same process; other agents keep what they remember.
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
     * @param out takes the state
     */
    void save(StateWriter out);

    /**
     * Takes on a state that was saved.
     *
     * @param in holds what {@link #save} wrote
     * @throws IllegalArgumentException if the bytes hold something else; the object may be half restored then
     */
    void restore(StateReader in);
}
