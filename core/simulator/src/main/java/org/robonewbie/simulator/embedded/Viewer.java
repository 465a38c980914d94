package org.robonewbie.simulator.embedded;

import java.io.IOException;
import java.net.URI;
import org.robonewbie.protocol.telemetry.TelemetrySink;
import org.robonewbie.simulator.SimulationControl;

/** A user interface for simulations. The studio registers one with {@link java.util.ServiceLoader}. */
public interface Viewer {

    /**
     * Opens a view of a simulation.
     *
     * @param simulation the simulation to show and control
     * @param port TCP port on 127.0.0.1; 0 for the default port, or for any free port if the default is in use
     * @return the open view
     * @throws IOException if the port cannot be opened
     */
    View open(SimulationControl simulation, int port) throws IOException;

    /**
     * Opens a view of a simulation, with permission to replace the program that started it.
     *
     * @param simulation the simulation to show and control
     * @param port TCP port on 127.0.0.1; 0 for the default port, or for any free port if the default is in use
     * @param program the program that started the simulation
     * @return the open view
     * @throws IOException if the port cannot be opened
     */
    default View open(SimulationControl simulation, int port, HostProgram program) throws IOException {
        return open(simulation, port);
    }

    /** An open view. */
    interface View extends AutoCloseable {

        /** {@return the address of the view for an authorised browser} */
        URI address();

        /**
         * Returns an address that authorises a browser: it contains a code that expires after one use or ten minutes.
         * {@link Browser} opens it without revealing the code to other users of the computer.
         *
         * @return a new address on each call
         */
        URI oneTimeAddress();

        /** {@return whether a page is connected} */
        boolean isWatched();

        /**
         * Returns the sink for the telemetry of robots. It must be thread-safe, because it is used by robots in this
         * process and, through a {@link org.robonewbie.protocol.tcp.TelemetryServer}, by robots in other processes.
         *
         * @return the sink for log lines, beliefs and drawings; {@link TelemetrySink#NONE} if this view does not show
         *     telemetry
         */
        default TelemetrySink telemetry() {
            return TelemetrySink.NONE;
        }

        /** Closes the view. Connected pages show that it has been closed. */
        @Override
        void close();
    }
}
