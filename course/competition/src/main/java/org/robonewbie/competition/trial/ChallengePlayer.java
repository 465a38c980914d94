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

/** Runs the trials of a {@link ChallengeContest}, in which the teams' programs control the robots. */
public final class ChallengePlayer implements TrialPlayer {

    private final Supplier<? extends Challenge> challenge;
    private final Map<String, TeamProgram> programs;
    private final Limits limits;
    private final Sandbox sandbox;
    private final Spectators spectators;

    /**
     * Creates a player.
     *
     * @param challenge supplies a new challenge for each trial
     * @param programs programs by team name
     * @param limits resource limits per program
     * @param sandbox sandbox for the programs
     * @param spectators live viewers
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
        List<String> notices = new CopyOnWriteArrayList<>();
        try (AdmissionControl admission = new AdmissionControl(sandbox, programs, limits, files, notices::add);
                RemoteAgents agents = new RemoteAgents(trial, files, limits, admission)) {
            return play(trial, files, agents);
        } finally {
            files.writeNotices(trial.id(), notices);
        }
    }

    private TrialResult play(ContestTrial trial, TrialFiles files, RemoteAgents agents) throws IOException {
        WatchedTrial watched = new WatchedTrial();
        Runnable leaving = spectators.watch(watched, trial);
        Challenge tried = challenge.get();
        try {
            double seconds = tried.play(
                    trial.seconds(),
                    trial.seed(),
                    trial.entrants().get(0).team(),
                    agents::next,
                    spectators.isNobody() ? TrialListener.NONE : watched,
                    RecordingFile.openIfWanted(files.recording(), sentence -> {}));
            return result(trial, seconds, Ending.PLAYED, tried.figures(), OptionalInt.empty());
        } catch (AbsentProgramException absent) {
            return result(trial, 0, agents.end(absent), Map.of(), agents.exitCode());
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
