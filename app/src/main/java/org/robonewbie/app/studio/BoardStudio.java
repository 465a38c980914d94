package org.robonewbie.app.studio;

import java.io.IOException;
import java.net.URI;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.embedded.Browser;
import org.robonewbie.simulator.embedded.EnterKey;
import org.robonewbie.simulator.embedded.Viewer;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;
import org.robonewbie.studio.StudioFolders;
import org.robonewbie.studio.StudioServer;
import org.robonewbie.studio.StudioViewer;
import org.robonewbie.studio.board.EventBus;

/** A studio with an empty pitch whose first page is the board on which a program reports its progress. */
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
     * @param board what its first page shows
     * @param port of the page, 0 for the usual one, or any other if that is taken
     * @param folders what of the disk the pages may use
     * @return the open studio
     * @throws IOException if the port cannot be opened
     */
    static BoardStudio open(EventBus board, int port, StudioFolders folders) throws IOException {
        SimulatorSettings pitch = SimulatorSettings.beginner()
                .agentPort(0)
                .synchronous(true)
                .awaitedAgents(1)
                .build();
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

    /** Returns what to print: an address that lets one browser in, and how to get another one. */
    String invitation() {
        return oneTimeAddress() + EnterKey.listen(this);
    }

    /** Returns the studio itself. */
    StudioServer server() {
        return view;
    }

    @Override
    public boolean isWatched() {
        return board.isWatched();
    }

    /** Opens the page in the browser. */
    void showBrowser() {
        Browser.openUnlessWatched(this, Console.standard());
    }

    /**
     * Waits until no page is open any more.
     *
     * @throws InterruptedException if the thread is interrupted while it waits
     */
    void awaitUnwatched() throws InterruptedException {
        if (board.isWatched()) {
            System.out.println("The page stays until you close it, or press Control-C here.");
            board.awaitUnwatched(view::isWatched);
        }
    }

    @Override
    public void close() {
        view.close();
        world.close();
    }
}
