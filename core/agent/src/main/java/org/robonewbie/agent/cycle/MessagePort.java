package org.robonewbie.agent.cycle;

import java.io.IOException;
import java.util.List;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.perceptor.PerceptorMessage;

/** The source of a robot's perceptions and the destination of its commands. */
public interface MessagePort extends AutoCloseable {

    /**
     * Waits for the next perception.
     *
     * @return false if there are no more
     * @throws IOException if the connection is broken
     */
    boolean receive() throws IOException;

    /** {@return the perception that was received last} */
    PerceptorMessage message();

    /**
     * Sends the answer to the last perception.
     *
     * @param commands what the robot does, with {@code Synchronise} at the end
     * @throws IOException if the connection is broken
     */
    void send(List<EffectorCommand> commands) throws IOException;

    @Override
    void close();
}
