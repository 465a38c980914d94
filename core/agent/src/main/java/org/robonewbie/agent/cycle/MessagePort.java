package org.robonewbie.agent.cycle;

import java.io.IOException;
import java.util.List;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.perceptor.PerceptorMessage;

/** Source of a robot's perceptor messages and sink for its commands. */
public interface MessagePort extends AutoCloseable {

    /**
     * Waits for the next perceptor message.
     *
     * @return false if there are no more
     * @throws IOException if the connection is broken
     */
    boolean receive() throws IOException;

    /** {@return the last perceptor message} */
    PerceptorMessage message();

    /**
     * Sends the response to the last perceptor message.
     *
     * @param commands the robot's commands, with {@code Synchronise} at the end
     * @throws IOException if the connection is broken
     */
    void send(List<EffectorCommand> commands) throws IOException;

    /** {@return the number of messages from a beam until the robot stands still} */
    default int messagesToSettle() {
        return 15;
    }

    /**
     * Checks whether the simulator has advanced without waiting for the robot's answer.
     *
     * @return whether the next message has already arrived
     * @throws IOException if the connection is broken
     */
    default boolean isLate() throws IOException {
        return false;
    }

    @Override
    void close();
}
