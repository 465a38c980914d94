package org.robonewbie.studio;

import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;

/** Queue of user commands. They run in order, and may wait for the simulation or for robots that join. */
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
     * Sends the simulation a request and waits for the answer.
     *
     * @param none the result if the simulation has ended
     * @param request starts the request with the given callback
     * @return the answer
     */
    <T> T answer(T none, Consumer<Consumer<T>> request);

    /**
     * Waits for a condition, for some seconds at most.
     *
     * @param condition the condition
     */
    void await(BooleanSupplier condition);

    @Override
    void close();
}
