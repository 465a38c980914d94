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
 * A studio that shows a contest while it is held: a wall of all running trials and the table. Each trial has a studio of its own,
 * in which it can be seen large.
 */
public final class ContestStudio implements Spectators, AutoCloseable {

    private static final long MOST_MILLIS_FOR_EYES = 20_000;
    private static final String RECORDINGS = "recordings";

    private final TrialWall wall;
    private final BoardStudio studio;
    private boolean hasWaited;

    private ContestStudio(TrialWall wall, BoardStudio studio) {
        this.wall = wall;
        this.studio = studio;
    }

    /**
     * Opens the wall.
     *
     * @param contest what is held
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

    /** {@return what to print: an address that lets one browser in, and how to get another one} */
    public String invitation() {
        return studio.invitation();
    }

    /** Opens the wall in the browser. */
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

    /** Waits for a page that shows the first trials, since some are over in seconds, but never delays a contest for long. */
    private synchronized void awaitEyes() throws IOException {
        try {
            if (!hasWaited) {
                wall.awaitWatched(MOST_MILLIS_FOR_EYES);
            }
            hasWaited = true;
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
            throw (IOException) new InterruptedIOException("The contest was stopped.").initCause(stop);
        }
    }

    /**
     * Shows that the contest is over, and stays until nobody looks any more.
     *
     * @param words where its results are
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
