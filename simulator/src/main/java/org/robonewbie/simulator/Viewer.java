package org.robonewbie.simulator;

import java.io.IOException;
import java.net.URI;

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

        /** Closes the view; browsers that look at it say so. */
        @Override
        void close();
    }
}
