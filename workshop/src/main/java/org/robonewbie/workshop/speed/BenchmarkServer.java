package org.robonewbie.workshop.speed;

import java.io.IOException;
import java.util.List;
import java.util.OptionalLong;
import org.robonewbie.nao.Vector3;

/** Server under test: the embedded one, or any other in sync mode. */
interface BenchmarkServer extends AutoCloseable {

    /** Connects robots and waits until all have joined their teams and replied to the last message. */
    List<BenchmarkAgent> gather(int robots) throws IOException;

    /** Runs a cycle once all agents have replied. */
    void cycle();

    /** Places a robot upright. */
    void place(int robot, Vector3 position) throws IOException;

    /** Starts the game. */
    void playOn() throws IOException;

    /** {@return the processor time of the server in nanoseconds; empty if unknown} */
    OptionalLong cpuNanoseconds();

    /** {@return the memory allocated by the server in bytes; empty if unknown} */
    OptionalLong allocatedBytes();

    @Override
    void close();
}
