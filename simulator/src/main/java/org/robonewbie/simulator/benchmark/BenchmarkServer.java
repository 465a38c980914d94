package org.robonewbie.simulator.benchmark;

import java.io.IOException;
import java.util.OptionalLong;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.frame.AgentLink;

/** The server whose speed is measured: ours in this process, or any other in sync mode. */
interface BenchmarkServer extends AutoCloseable {

    /** Connects an agent. */
    AgentLink connect() throws IOException;

    /** Lets a cycle pass once all agents have answered. */
    void cycle();

    /** Puts a robot somewhere, upright. */
    void place(int robot, Vector3 position) throws IOException;

    /** Lets the game begin. */
    void playOn() throws IOException;

    /** Tells how much processor time the server has had, in nanoseconds; empty if nobody knows. */
    OptionalLong cpuNanoseconds();

    /** Tells how much memory was allocated for it, in bytes; empty if nobody knows. */
    OptionalLong allocatedBytes();

    @Override
    void close();
}
