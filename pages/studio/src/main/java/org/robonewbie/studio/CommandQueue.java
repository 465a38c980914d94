package org.robonewbie.studio;

import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;

/** Where what people do to the world waits: for what was done before it, for the simulation, and for robots that come. */
interface CommandQueue extends AutoCloseable {

    /**
     * Does some work after all that was given before.
     *
     * @param work what is done
     */
    void later(Runnable work);

    /**
     * Does some work after all that was given before, and waits for it.
     *
     * @param work what is done
     * @return its result
     * @throws IllegalStateException if the work is refused; the message says why
     */
    <T> T result(Supplier<T> work);

    /**
     * Asks the simulation.
     *
     * @param none the answer of a simulation that has ended
     * @param request asks, and names who takes the answer
     * @return the answer
     */
    <T> T answer(T none, Consumer<Consumer<T>> request);

    /**
     * Waits until something has come about, for some seconds at most.
     *
     * @param condition whether it has
     */
    void await(BooleanSupplier condition);

    @Override
    void close();
}
