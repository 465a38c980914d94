package org.robonewbie.learning.gym;

import java.io.IOException;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.embedded.Viewer;

/**
 * Where people can watch what learning programs do, such as the studio.
 *
 * <pre>{@code
 * GymStage studio = simulation -> StudioServer.start(simulation, 0, AccessToken.ofUser());
 * }</pre>
 */
@FunctionalInterface
public interface GymStage {

    /** No stage. */
    GymStage NONE = simulation -> {
        throw new IllegalArgumentException("This server cannot show what robots do.");
    };

    /**
     * Shows a robot that learns.
     *
     * @param simulation what to show
     * @return the open view
     * @throws IOException if its port cannot be opened
     */
    Viewer.View show(SimulationControl simulation) throws IOException;
}
