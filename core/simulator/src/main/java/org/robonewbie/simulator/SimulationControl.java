package org.robonewbie.simulator;

import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Consumer;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.state.WorldState;

/** Thread-safe control of a running simulation. Requests take effect between two cycles. */
public interface SimulationControl {

    /** Speed factor for {@link Order.SetSpeed} that disables waiting between cycles. */
    double AS_FAST_AS_POSSIBLE = Double.POSITIVE_INFINITY;

    /** {@return the pitch} */
    SoccerField field();

    /** {@return ball and markings of the pitch} */
    default PitchDetails pitchDetails() {
        return PitchDetails.SIMSPARK;
    }

    /**
     * Returns whether the state of the match can be set.
     *
     * @return false for a server that knows no orders to set play mode, score and time, and none to reset the match
     */
    default boolean canSetMatch() {
        return true;
    }

    /**
     * Returns whether the clock can be controlled and the world can be restored.
     *
     * @return false for a view-only world, which accepts no {@link Order.Clock} and cannot be {@link #restore restored}
     */
    default boolean hasClock() {
        return true;
    }

    /**
     * Queues a command for execution before the next cycle. Commands for a missing robot and commands that this world does not
     * support have no effect.
     *
     * @param order the command
     * @throws UnsupportedOperationException for a clock command to a world that {@link #hasClock has no clock}
     */
    void order(Order order);

    /**
     * Continues from an earlier snapshot. Robots that have since left the game are skipped.
     *
     * @param before a snapshot before {@code target}, used to derive velocities; {@code target} itself for a world at rest
     * @param target the snapshot to continue from
     */
    default void restore(WorldSnapshot before, WorldSnapshot target) {}

    /** {@return the graded trial that is running in this world; empty for free play} */
    default Optional<TrialLabel> trial() {
        return Optional.empty();
    }

    /** {@return the TCP port for agents; empty if agents cannot join} */
    default OptionalInt agentPort() {
        return OptionalInt.empty();
    }

    /**
     * Connects an in-process agent.
     *
     * @return the agent's end of the connection; empty if agents cannot join
     */
    default Optional<AgentLink> connect() {
        return Optional.empty();
    }

    /**
     * Adds an observer.
     *
     * @param observer called on the simulation thread after each cycle
     */
    void addObserver(SimulationObserver observer);

    /**
     * Removes an observer.
     *
     * @param observer the observer
     */
    void removeObserver(SimulationObserver observer);

    /**
     * Saves the exact state of the world between two cycles, as soon as every agent has responded.
     *
     * @param receiver receives the state on the simulation thread; empty if the world cannot be saved or an agent does
     *     not respond in time
     */
    default void save(Consumer<Optional<WorldState>> receiver) {
        receiver.accept(Optional.empty());
    }

    /**
     * Restores a saved state between two cycles, as soon as every agent has responded. The cycle counter and the
     * recording continue. In-process agents that offer their state are also restored; other agents keep their current
     * state.
     *
     * @param state the state
     * @param receiver receives the number of restored agents; empty if the state is incompatible with this world, which
     *     then remains unchanged, or if an agent does not respond in time
     */
    default void restore(WorldState state, Consumer<OptionalInt> receiver) {
        receiver.accept(OptionalInt.empty());
    }
}
