package org.robonewbie.agent;

import java.io.IOException;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.PerceptorMessage;

/** Where a robot gets its perceptions from and brings its commands to. */
interface MessagePort extends AutoCloseable {

    /** Waits for the next perception; false if there will be none any more. */
    boolean receive() throws IOException;

    /** Gives the perception that was received last. */
    PerceptorMessage message();

    /** Sends the answer to the last perception. */
    void send(MessageBuffer commands) throws IOException;

    /** Whether the simulator has already sent another perception without waiting for the answer. */
    boolean isLate() throws IOException;

    @Override
    void close();
}
