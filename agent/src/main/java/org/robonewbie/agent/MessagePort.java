package org.robonewbie.agent;

import java.io.IOException;
import java.util.Optional;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.PerceptorMessage;

/** Where a robot gets its perceptions from and brings its commands to. */
interface MessagePort extends AutoCloseable {

    /** Waits for the next perception; empty if there will be none any more. */
    Optional<PerceptorMessage> receive() throws IOException;

    /** Sends the answer to the last perception. */
    void send(MessageBuffer commands) throws IOException;

    /** Whether the simulator has already sent another perception without waiting for the answer. */
    boolean isLate() throws IOException;

    @Override
    void close();
}
