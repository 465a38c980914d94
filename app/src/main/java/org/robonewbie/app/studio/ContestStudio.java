package org.robonewbie.app.studio;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.robonewbie.competition.contest.Contest;
import org.robonewbie.competition.contest.ContestTrial;
import org.robonewbie.competition.contest.Entrant;
import org.robonewbie.competition.contest.Table;
import org.robonewbie.competition.trial.ContestProgress;
import org.robonewbie.competition.trial.Spectators;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.studio.StudioFolders;
import org.robonewbie.studio.StudioServer;
import org.robonewbie.studio.wall.TrialWall;
import org.robonewbie.studio.wall.WallTable;

/**
 * Studio for a running contest. The contest display shows all running trials side by side, and the league table. Each trial
 * is also shown full size in a separate studio.
 */
public final class ContestStudio implements Spectators, AutoCloseable {

    private static final long MAX_WAIT_MILLIS = 20_000;
    private static final String RECORDINGS = "recordings";

    private final TrialWall wall;
    private final BoardStudio studio;
    private boolean hasWaited;

    private ContestStudio(TrialWall wall, BoardStudio studio) {
        this.wall = wall;
        this.studio = studio;
    }

    /**
     * Opens the contest display.
     *
     * @param contest the contest
     * @param results the folder of its results
     * @return the open studio
     * @throws IOException if no port can be opened
     */
    public static ContestStudio open(Contest contest, Path results) throws IOException {
        StudioFolders own = StudioFolders.ofWorkingDirectory();
        StudioFolders folders = new StudioFolders(
                own.motions(),
                own.scenes(),
                Optional.empty(),
                List.of(results.resolve(RECORDINGS).toAbsolutePath()),
                Optional.empty());
        TrialWall wall = new TrialWall(contest.title(), contest.rule());
        try {
            return new ContestStudio(wall, BoardStudio.open(wall, 0, folders));
        } catch (IOException noPort) {
            wall.close();
            throw noPort;
        }
    }

    /** {@return the text to print: a one-time URL, and how to get another one} */
    public String invitation() {
        return studio.invitation();
    }

    /** Opens the contest display in the browser. */
    public void showBrowser() {
        studio.showBrowser();
    }

    @Override
    public void stands(ContestProgress progress) {
        Table table = progress.table();
        List<WallTable.Place> places = table.rows().stream()
                .map(row -> new WallTable.Place(row.rank(), row.team(), row.cells()))
                .toList();
        progress.last().ifPresent(last -> wall.result(last.id(), last.inWords()));
        wall.stands(new WallTable(progress.over(), progress.planned(), table.columns(), places));
    }

    @Override
    public Runnable watch(SimulationControl simulation, ContestTrial trial) throws IOException {
        StudioServer alone = StudioServer.startBeside(simulation, studio.server());
        List<String> teams = trial.entrants().stream().map(Entrant::team).toList();
        wall.begins(trial.id(), teams, simulation, alone.address());
        awaitEyes();
        return () -> {
            wall.ends(trial.id());
            alone.close();
        };
    }

    /** Before the first trial, waits for a limited time until a page is open, because some trials take only seconds. */
    private synchronized void awaitEyes() throws IOException {
        try {
            if (!hasWaited) {
                wall.awaitWatched(MAX_WAIT_MILLIS);
            }
            hasWaited = true;
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
            throw (IOException) new InterruptedIOException("The contest was stopped.").initCause(stop);
        }
    }

    /**
     * Shows that the contest has ended, and waits until no page is open.
     *
     * @param words sentence with the location of the results
     * @throws InterruptedException if the thread is interrupted while it waits
     */
    public void isOver(String words) throws InterruptedException {
        wall.isOver(words);
        studio.awaitUnwatched();
    }

    @Override
    public void close() {
        wall.close();
        studio.close();
    }
}
