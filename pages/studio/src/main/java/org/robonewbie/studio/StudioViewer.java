package org.robonewbie.studio;

import java.io.IOException;
import java.util.Optional;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.embedded.Viewer;
import org.robonewbie.studio.board.EventBus;
import org.robonewbie.studio.course.Course;
import org.robonewbie.studio.program.CompilerService;

/**
 * Shows simulations in the browser; found by {@link java.util.ServiceLoader}.
 *
 * <p>If any port will do it takes the same one in each run, so that a page that is still open reconnects.
 */
public final class StudioViewer implements Viewer {

    /** The port that is taken if it is free and no other is asked for. */
    public static final int USUAL_PORT = 3400;

    @Override
    public View open(SimulationControl simulation, int port) throws IOException {
        return open(simulation, port, StudioFolders.ofWorkingDirectory());
    }

    /**
     * Starts to show a simulation and what is in some folders.
     *
     * @param simulation what to show and steer
     * @param port TCP port on 127.0.0.1, 0 for the usual one, or any other if that is taken
     * @param folders what of the disk the pages may use
     * @return the open view
     * @throws IOException if the port cannot be opened
     */
    public static View open(SimulationControl simulation, int port, StudioFolders folders) throws IOException {
        return open(simulation, port, folders, Optional.empty());
    }

    /**
     * Starts to show the board of a program, together with the contents of some folders.
     *
     * @param simulation a world for the other rooms
     * @param port TCP port on 127.0.0.1, 0 for the usual one, or any other if that is taken
     * @param folders the folders that the pages may use
     * @param board what the program writes to; see {@link EventBus#page} for its address
     * @return the open view
     * @throws IOException if the port cannot be opened
     */
    public static StudioServer open(SimulationControl simulation, int port, StudioFolders folders, EventBus board)
            throws IOException {
        return open(simulation, port, folders, Optional.of(board));
    }

    /**
     * Starts to show a simulation with exercises and programs.
     *
     * @param simulation what to show and steer
     * @param port TCP port on 127.0.0.1, 0 for the usual one, or any other if that is taken
     * @param folders what of the disk the pages may use
     * @param course the exercises
     * @param compiler compiles and starts programs
     * @return the open view
     * @throws IOException if the port cannot be opened
     */
    public static StudioServer open(
            SimulationControl simulation, int port, StudioFolders folders, Course course, CompilerService compiler)
            throws IOException {
        AccessToken token = AccessToken.ofUser();
        try {
            return StudioServer.start(simulation, port == 0 ? USUAL_PORT : port, token, folders, course, compiler);
        } catch (IOException inUse) {
            if (port != 0) {
                throw inUse;
            }
            return StudioServer.start(simulation, 0, token, folders, course, compiler);
        }
    }

    private static StudioServer open(
            SimulationControl simulation, int port, StudioFolders folders, Optional<EventBus> board)
            throws IOException {
        return port == 0
                ? openAtUsual(USUAL_PORT, simulation, folders, board)
                : StudioServer.start(simulation, port, AccessToken.ofUser(), folders, board);
    }

    /** Takes a port if it is free, and any other if it is not. */
    static StudioServer openAtUsual(
            int port, SimulationControl simulation, StudioFolders folders, Optional<EventBus> board)
            throws IOException {
        AccessToken token = AccessToken.ofUser();
        try {
            return StudioServer.start(simulation, port, token, folders, board);
        } catch (IOException e) {
            return StudioServer.start(simulation, 0, token, folders, board);
        }
    }
}
