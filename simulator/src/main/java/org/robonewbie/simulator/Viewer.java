package org.robonewbie.simulator;

import java.io.IOException;
import java.net.URI;
import org.robonewbie.protocol.telemetry.TelemetrySink;

/** Shows simulations to people. The studio offers one by {@link java.util.ServiceLoader}. */
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

        /**
         * Tells where people can look.
         *
         * @return the address for a browser, with the token that it needs
         */
        URI address();

        /**
         * Tells whether anybody looks now.
         *
         * @return whether a page is connected
         */
        boolean isWatched();

        /**
         * Tells who shows what robots think. Robots of this process and, through a {@link
         * org.robonewbie.protocol.telemetry.TelemetryServer}, of other processes call it from several threads.
         *
         * @return takes log lines, beliefs and drawings; {@link TelemetrySink#NONE} if this view does not show them
         */
        default TelemetrySink telemetry() {
            return TelemetrySink.NONE;
        }

        /** Closes the view; browsers that look at it say so. */
        @Override
        void close();
    }
}
