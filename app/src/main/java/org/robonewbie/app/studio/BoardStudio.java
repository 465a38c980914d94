package org.robonewbie.app.studio;

import java.io.IOException;
import java.net.URI;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.embedded.Browser;
import org.robonewbie.simulator.embedded.EnterKey;
import org.robonewbie.simulator.embedded.Viewer;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;
import org.robonewbie.studio.StudioFolders;
import org.robonewbie.studio.StudioServer;
import org.robonewbie.studio.StudioViewer;
import org.robonewbie.studio.board.EventBus;

/** Studio with an empty pitch. Its first page shows the progress of a command, such as a contest or an optimisation. */
final class BoardStudio implements Viewer.View {

    private final EventBus board;
    private final Simulator world;
    private final StudioServer view;

    private BoardStudio(EventBus board, Simulator world, StudioServer view) {
        this.board = board;
        this.world = world;
        this.view = view;
    }

    /**
     * Opens the studio.
     *
     * @param board the event bus of the progress page
     * @param port TCP port of the page; 0 for the default port, or for any free port if that one is in use
     * @param folders the folders that the pages may access
     * @throws IOException if the port cannot be opened
     */
    static BoardStudio open(EventBus board, int port, StudioFolders folders) throws IOException {
        SimulatorSettings pitch =
                SimulatorSettings.of(WorldSettings.beginner()).withAgentPort(0).withAwaitedAgents(1);
        Simulator world = Simulator.start(pitch, Console.silent());
        try {
            return new BoardStudio(board, world, StudioViewer.open(world.control(), port, folders, board));
        } catch (IOException portInUse) {
            world.close();
            throw portInUse;
        }
    }

    @Override
    public URI address() {
        return board.page(view.address());
    }

    @Override
    public URI oneTimeAddress() {
        return board.page(view.oneTimeAddress());
    }

    /** Returns the text to print: a one-time URL, and how to get another one. */
    String invitation() {
        return oneTimeAddress() + EnterKey.listen(this);
    }

    StudioServer server() {
        return view;
    }

    @Override
    public boolean isWatched() {
        return board.isWatched();
    }

    void showBrowser() {
        Browser.openUnlessWatched(this, Console.standard());
    }

    /**
     * Waits until no page is open.
     *
     * @throws InterruptedException if the thread is interrupted while it waits
     */
    void awaitUnwatched() throws InterruptedException {
        if (board.isWatched()) {
            System.out.println("The page stays open until you close it or press Control-C here.");
            board.awaitUnwatched(view::isWatched);
        }
    }

    @Override
    public void close() {
        view.close();
        world.close();
    }
}
