package org.robonewbie.competition.trial;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Supplier;
import org.robonewbie.competition.contest.ChallengeContest;
import org.robonewbie.competition.contest.ContestTrial;
import org.robonewbie.competition.contest.Ending;
import org.robonewbie.competition.contest.TeamResult;
import org.robonewbie.competition.contest.TrialResult;
import org.robonewbie.competition.team.TeamProgram;
import org.robonewbie.programs.process.AbsentProgramException;
import org.robonewbie.programs.process.Limits;
import org.robonewbie.programs.process.Sandbox;
import org.robonewbie.simulator.file.RecordingFile;
import org.robonewbie.trial.Challenge;
import org.robonewbie.trial.TrialListener;
import org.robonewbie.trial.watch.WatchedTrial;

/** Plays the trials of a {@link ChallengeContest}, with the teams' programs as guests. */
public final class ChallengePlayer implements TrialPlayer {

    private final Supplier<? extends Challenge> challenge;
    private final Map<String, TeamProgram> programs;
    private final Limits limits;
    private final Sandbox sandbox;
    private final Spectators spectators;

    /**
     * Creates a player of trials.
     *
     * @param challenge makes the challenge of each trial
     * @param programs of the teams, by name
     * @param limits of time and memory of a program
     * @param sandbox where programs run, if there is a sandbox
     * @param spectators who watches
     */
    public ChallengePlayer(
            Supplier<? extends Challenge> challenge,
            Map<String, TeamProgram> programs,
            Limits limits,
            Sandbox sandbox,
            Spectators spectators) {
        this.challenge = challenge;
        this.programs = Map.copyOf(programs);
        this.limits = limits;
        this.sandbox = sandbox;
        this.spectators = spectators;
    }

    @Override
    public TrialResult run(ContestTrial trial, TrialFiles files) throws IOException {
        TeamProgram program = programs.get(trial.entrants().get(0).team());
        if (program == null) {
            return result(trial, 0, Ending.NOT_STARTED, Map.of(), OptionalInt.empty());
        }
        if (program instanceof TeamProgram.Broken broken) {
            return result(trial, 0, broken.ending(), Map.of(), OptionalInt.empty());
        }
        List<String> noticed = new CopyOnWriteArrayList<>();
        try (AdmissionControl doorkeeper = new AdmissionControl(sandbox, programs, limits, files, noticed::add);
                RemoteAgents guests = new RemoteAgents(trial, files, limits, doorkeeper)) {
            return play(trial, files, guests);
        } finally {
            files.tell(trial.id(), noticed);
        }
    }

    private TrialResult play(ContestTrial trial, TrialFiles files, RemoteAgents guests) throws IOException {
        WatchedTrial watched = new WatchedTrial();
        Runnable leaving = spectators.watch(watched, trial);
        Challenge tried = challenge.get();
        try {
            double seconds = tried.play(
                    trial.seconds(),
                    trial.seed(),
                    trial.entrants().get(0).team(),
                    guests::next,
                    spectators.isNobody() ? TrialListener.NONE : watched,
                    RecordingFile.openIfWanted(files.recording(), sentence -> {}));
            return result(trial, seconds, Ending.PLAYED, tried.figures(), OptionalInt.empty());
        } catch (AbsentProgramException absent) {
            return result(trial, 0, guests.end(absent), Map.of(), guests.exitCode());
        } finally {
            leaving.run();
        }
    }

    private static TrialResult result(
            ContestTrial trial, double seconds, Ending ending, Map<String, Double> figures, OptionalInt exitCode) {
        TeamResult result =
                TeamResult.of(trial.entrants().get(0).team(), ending, figures).withExitCode(exitCode);
        return new TrialResult(trial.id(), trial.seed(), seconds, List.of(result));
    }
}
