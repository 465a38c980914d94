package org.robonewbie.competition.trial;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Timer;
import java.util.TimerTask;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Supplier;
import org.robonewbie.competition.contest.ChallengeContest;
import org.robonewbie.competition.contest.ContestTrial;
import org.robonewbie.competition.contest.Ending;
import org.robonewbie.competition.contest.Entrant;
import org.robonewbie.competition.contest.Role;
import org.robonewbie.competition.contest.StartPlace;
import org.robonewbie.competition.contest.TeamResult;
import org.robonewbie.competition.contest.TrialResult;
import org.robonewbie.competition.team.Limits;
import org.robonewbie.competition.team.Start;
import org.robonewbie.competition.team.TeamProcess;
import org.robonewbie.competition.team.TeamProgram;
import org.robonewbie.simulator.file.RecordingFile;
import org.robonewbie.trial.Audience;
import org.robonewbie.trial.Challenge;
import org.robonewbie.trial.Performer;
import org.robonewbie.trial.guest.AbsentProgramException;
import org.robonewbie.trial.guest.GuestDoor;
import org.robonewbie.trial.watch.WatchedTrial;

/** Plays the trials of a {@link ChallengeContest}, with the teams' programs as guests. */
public final class ChallengePlayer implements TrialPlayer {

    private static final long LOOK_MILLISECONDS = 100;

    private final Supplier<? extends Challenge> challenge;
    private final Map<String, TeamProgram> programs;
    private final Limits limits;
    private final Spectators spectators;

    /**
     * Creates a player of trials.
     *
     * @param challenge makes the challenge of each trial
     * @param programs of the teams, by name
     * @param limits of time and memory of a program
     * @param spectators who watches
     */
    public ChallengePlayer(
            Supplier<? extends Challenge> challenge,
            Map<String, TeamProgram> programs,
            Limits limits,
            Spectators spectators) {
        this.challenge = challenge;
        this.programs = Map.copyOf(programs);
        this.limits = limits;
        this.spectators = spectators;
    }

    @Override
    public TrialResult run(ContestTrial trial, TrialFiles files) throws IOException {
        Entrant entrant = trial.entrants().get(0);
        TeamProgram program = programs.get(entrant.team());
        if (program == null || program instanceof TeamProgram.Broken) {
            return result(trial, entrant.team(), Ending.NOT_COMPILED, Map.of());
        }
        List<TeamProcess> processes = new CopyOnWriteArrayList<>();
        Timer guard = new Timer("guard-of-programs", true);
        guard.schedule(
                new TimerTask() {
                    @Override
                    public void run() {
                        processes.forEach(TeamProcess::check);
                    }
                },
                0,
                LOOK_MILLISECONDS);
        try {
            return play(trial, files, program, processes);
        } finally {
            guard.cancel();
            processes.forEach(TeamProcess::close);
        }
    }

    private TrialResult play(ContestTrial trial, TrialFiles files, TeamProgram program, List<TeamProcess> processes)
            throws IOException {
        String team = trial.entrants().get(0).team();
        WatchedTrial watched = new WatchedTrial();
        Runnable leaving = spectators.watch(watched, trial);
        try (GuestDoor door = GuestDoor.open(0, limits.silentSeconds())) {
            Challenge tried = challenge.get();
            tried.play(
                    trial.seconds(),
                    trial.seed(),
                    () -> robot(trial, files, program, processes, door),
                    spectators.isNobody() ? Audience.NOBODY : watched,
                    RecordingFile.openIfWanted(files.recording(), sentence -> {}));
            return result(trial, team, Ending.PLAYED, tried.figures());
        } catch (AbsentProgramException absent) {
            Ending ending = processes.stream()
                    .map(TeamProcess::ending)
                    .filter(reason -> reason != Ending.SILENT)
                    .findFirst()
                    .orElse(Ending.SILENT);
            return result(trial, team, ending, Map.of());
        } finally {
            leaving.run();
        }
    }

    /** Starts the program for the next robot, and waits until it comes. */
    private Performer robot(
            ContestTrial trial, TrialFiles files, TeamProgram program, List<TeamProcess> processes, GuestDoor door) {
        int number = processes.size() + 1;
        String name = trial.id() + (number == 1 ? "" : "-" + number);
        try {
            TeamProcess process = TeamProcess.start(
                    program,
                    new Start(door.port(), "Students", Role.MAIN, List.of(new StartPlace(number, -1, 0, 0))),
                    limits,
                    files.work().resolve(name),
                    files.logs().resolve(name + ".txt"));
            processes.add(process);
            long end = System.nanoTime() + (long) (limits.startSeconds() * 1e9);
            return door.await(() -> process.isRunning() && System.nanoTime() < end);
        } catch (IOException unstartable) {
            throw new AbsentProgramException("The program cannot be started.", unstartable);
        }
    }

    private static TrialResult result(ContestTrial trial, String team, Ending ending, Map<String, Double> figures) {
        return new TrialResult(
                trial.id(), trial.seed(), trial.seconds(), List.of(TeamResult.of(team, ending, figures)));
    }
}
