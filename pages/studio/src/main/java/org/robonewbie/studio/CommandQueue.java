package org.robonewbie.studio;

import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * First-in, first-out queue of user commands. A command may block until the simulation has responded or until robots have
 * joined.
 */
interface CommandQueue extends AutoCloseable {

    /**
     * Enqueues a command.
     *
     * @param work the command
     */
    void later(Runnable work);

    /**
     * Enqueues a command and waits for its result.
     *
     * @param work the command
     * @return its result
     * @throws IllegalStateException if the command is refused; the message gives the reason
     */
    <T> T result(Supplier<T> work);

    /**
     * Sends a request to the simulation and waits for the answer.
     *
     * @param none the result if the simulation has ended
     * @param request sends the request and passes the answer to the given callback
     * @return the answer
     */
    <T> T answer(T none, Consumer<Consumer<T>> request);

    /**
     * Waits until a condition holds, for a few seconds at most.
     *
     * @param condition polled until it returns true
     */
    void await(BooleanSupplier condition);

    @Override
    void close();
}
