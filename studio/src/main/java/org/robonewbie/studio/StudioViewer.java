package org.robonewbie.studio;

import java.io.IOException;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.Viewer;

/** Shows simulations in the browser; found by {@link java.util.ServiceLoader}. */
public final class StudioViewer implements Viewer {

    @Override
    public View open(SimulationControl simulation, int port) throws IOException {
        return StudioServer.start(simulation, port, AccessToken.ofUser());
    }
}
