package org.robonewbie.simulator;

import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Consumer;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.state.WorldState;

/**
 * Steers a running simulation from any thread; what is asked for takes effect between two cycles.
 */
public interface SimulationControl {

    /** Speed factor for {@link Order.SetSpeed} that means: do not wait between cycles. */
    double AS_FAST_AS_POSSIBLE = Double.POSITIVE_INFINITY;

    /** {@return the pitch} */
    SoccerField field();

    /**
     * Returns whether the clock can be stopped and the world be restored.
     *
     * @return false for a world that is only watched, which takes no {@link Order.Clock} and cannot be {@link #restore restored}
     */
    default boolean hasClock() {
        return true;
    }

    /**
     * Gives an order, which is carried out before the next cycle. Orders that refer to no robot, or that this world does not
     * take, do nothing.
     *
     * @param order the order
     * @throws UnsupportedOperationException if it is for the clock and the world {@link #hasClock has none}
     */
    void order(Order order);

    /**
     * Continues the world from a state that was seen before. Robots of that state that are no longer in the game are left out.
     *
     * @param before an earlier state, from which the velocities are taken; the same state for a world at rest
     * @param moment the state to continue from
     */
    default void restore(WorldSnapshot before, WorldSnapshot moment) {}

    /** {@return the trial that is judged here; empty for a world in which everybody just plays} */
    default Optional<TrialLabel> trial() {
        return Optional.empty();
    }

    /** {@return the TCP port at which agents join; empty where they cannot} */
    default OptionalInt agentPort() {
        return OptionalInt.empty();
    }

    /**
     * Connects an agent of this process, which gets a robot as any other agent does.
     *
     * @return the agent's end of the connection; empty where agents cannot join
     */
    default Optional<AgentLink> connect() {
        return Optional.empty();
    }

    /**
     * Starts to report each cycle.
     *
     * @param observer called on the simulation's own thread
     */
    void addObserver(SimulationObserver observer);

    /**
     * Ends the reports.
     *
     * @param observer the observer
     */
    void removeObserver(SimulationObserver observer);

    /**
     * Saves the whole world to the bit between two cycles, when no agent's answer is missing.
     *
     * @param receiver takes the state, on the simulation's thread; empty where the world or its physics engine cannot be saved,
     *     or an agent does not answer in time
     */
    default void save(Consumer<Optional<WorldState>> receiver) {
        receiver.accept(Optional.empty());
    }

    /**
     * Lets the world go on from a saved state between two cycles, when no agent's answer is missing. The count of cycles and the
     * recording go on. Agents of this process that offer their state take it on; the others remember what they know.
     *
     * @param state the state
     * @param receiver takes the number of agents that were restored once the world has taken the state on; empty if it does not
     *     fit this world, which then stays as it is, or an agent does not answer in time
     */
    default void restore(WorldState state, Consumer<OptionalInt> receiver) {
        receiver.accept(OptionalInt.empty());
    }
}
