package org.robonewbie.studio;

import java.io.IOException;
import java.util.ServiceLoader;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.embedded.HostProgram;

/**
 * Opens the complete studio. The application provides an implementation through {@link ServiceLoader}; without one, the studio that an
 * agent opens has no exercises and cannot edit programs.
 */
public interface FullStudio {

    /**
     * Opens the studio.
     *
     * @param simulation the simulation to show and control
     * @param port TCP port on 127.0.0.1; 0 for the default port, or for any free port if that one is in use
     * @param program the program that is playing in the simulation, until it is replaced in the studio
     * @return the open studio
     * @throws IOException if the port cannot be opened
     */
    StudioServer open(SimulationControl simulation, int port, HostProgram program) throws IOException;
}
