package org.robonewbie.studio;

import java.io.IOException;
import java.util.Optional;
import java.util.ServiceLoader;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.embedded.HostProgram;
import org.robonewbie.simulator.embedded.Viewer;
import org.robonewbie.studio.board.EventBus;
import org.robonewbie.studio.program.CompilerService;
import org.robonewbie.studio.service.PageService;

/**
 * Viewer in the browser; found by {@link java.util.ServiceLoader}.
 *
 * <p>Prefers the same port in every run, so that a page that is still open can reconnect.
 */
public final class StudioViewer implements Viewer {

    /** Preferred TCP port if none is requested. */
    public static final int DEFAULT_PORT = 3400;

    @Override
    public View open(SimulationControl simulation, int port) throws IOException {
        return open(simulation, port, StudioFolders.ofWorkingDirectory());
    }

    @Override
    public View open(SimulationControl simulation, int port, HostProgram program) throws IOException {
        Optional<FullStudio> full = ServiceLoader.load(FullStudio.class).findFirst();
        return full.isPresent() ? full.get().open(simulation, port, program) : open(simulation, port);
    }

    /**
     * Shows a simulation with explicit folders.
     *
     * @param simulation the simulation to show and control
     * @param port TCP port on 127.0.0.1; 0 for the default port, or for any free port if that one is in use
     * @param folders the folders that the pages may access
     * @return the open view
     * @throws IOException if the port cannot be opened
     */
    public static View open(SimulationControl simulation, int port, StudioFolders folders) throws IOException {
        return open(simulation, port, folders, Optional.empty());
    }

    /**
     * Shows a simulation with the progress page of an event bus.
     *
     * @param simulation the simulation shown on the studio's other pages
     * @param port TCP port on 127.0.0.1; 0 for the default port, or for any free port if that one is in use
     * @param folders the folders that the pages may access
     * @param board the event bus; see {@link EventBus#page} for its address
     * @return the open view
     * @throws IOException if the port cannot be opened
     */
    public static StudioServer open(SimulationControl simulation, int port, StudioFolders folders, EventBus board)
            throws IOException {
        return open(simulation, port, folders, Optional.of(board));
    }

    /**
     * Shows a simulation with exercises and programs.
     *
     * @param simulation the simulation to show and control
     * @param port TCP port on 127.0.0.1; 0 for the default port, or for any free port if that one is in use
     * @param folders the folders that the pages may access
     * @param course the exercises; empty for a studio without any
     * @param compiler compiles and starts programs; empty for a studio without any
     * @return the open view
     * @throws IOException if the port cannot be opened
     */
    public static StudioServer open(
            SimulationControl simulation,
            int port,
            StudioFolders folders,
            Optional<PageService> course,
            Optional<CompilerService> compiler)
            throws IOException {
        AccessToken token = AccessToken.ofUser();
        return open(port, any -> StudioServer.start(simulation, any, token, folders, course, compiler));
    }

    private static StudioServer open(
            SimulationControl simulation, int port, StudioFolders folders, Optional<EventBus> board)
            throws IOException {
        AccessToken token = AccessToken.ofUser();
        return open(port, any -> StudioServer.start(simulation, any, token, folders, board));
    }

    private static StudioServer open(int port, Start start) throws IOException {
        return port == 0 ? openAtUsual(DEFAULT_PORT, start) : start.at(port);
    }

    /** Starts a server on a port, or on any free one if that port is in use. */
    static StudioServer openAtUsual(int port, Start start) throws IOException {
        try {
            return start.at(port);
        } catch (IOException inUse) {
            return start.at(0);
        }
    }

    /** Starts a server on a given port; 0 means any free one. */
    interface Start {
        StudioServer at(int port) throws IOException;
    }
}
