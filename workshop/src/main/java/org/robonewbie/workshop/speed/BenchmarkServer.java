package org.robonewbie.workshop.speed;

import java.io.IOException;
import java.util.List;
import java.util.OptionalLong;
import org.robonewbie.nao.Vector3;

/** The server whose speed is measured: ours in this process, or any other in sync mode. */
interface BenchmarkServer extends AutoCloseable {

    /** Lets so many robots join. All of them have answered their last message then. */
    List<BenchmarkAgent> gather(int robots) throws IOException;

    /** Runs a cycle once all agents have answered. */
    void cycle();

    /** Moves a robot, upright. */
    void place(int robot, Vector3 position) throws IOException;

    /** Starts the game. */
    void playOn() throws IOException;

    /** The processor time of the server in nanoseconds; empty if unknown. */
    OptionalLong cpuNanoseconds();

    /** The memory allocated by the server in bytes; empty if unknown. */
    OptionalLong allocatedBytes();

    @Override
    void close();
}
