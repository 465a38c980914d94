package org.robonewbie.simulator.embedded;

import java.io.IOException;
import java.net.URI;
import org.robonewbie.protocol.telemetry.TelemetrySink;
import org.robonewbie.simulator.SimulationControl;

/** Shows simulations to people. The studio registers one with {@link java.util.ServiceLoader}. */
public interface Viewer {

    /**
     * Starts to show a simulation.
     *
     * @param simulation what to show and steer
     * @param port TCP port on 127.0.0.1, 0 for the usual one, or any other if that is taken
     * @return the open view
     * @throws IOException if the port cannot be opened
     */
    View open(SimulationControl simulation, int port) throws IOException;

    /** A view that is open. */
    interface View extends AutoCloseable {

        /** {@return the address of the view for a browser that has been let in} */
        URI address();

        /**
         * Returns an address that lets a browser in: it holds a code that works once and for ten minutes. Print it for people;
         * {@link Browser} opens it without showing the code to other users of the computer.
         *
         * @return a new address in each call
         */
        URI oneTimeAddress();

        /** {@return whether a page is connected} */
        boolean isWatched();

        /**
         * Returns the sink for what robots think. Robots of this process and, through a {@link
         * org.robonewbie.protocol.tcp.TelemetryServer}, of other processes call it from several threads.
         *
         * @return receives log lines, beliefs and drawings; {@link TelemetrySink#NONE} if this view does not show them
         */
        default TelemetrySink telemetry() {
            return TelemetrySink.NONE;
        }

        /** Closes the view; browsers that look at it say so. */
        @Override
        void close();
    }
}
