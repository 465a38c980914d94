package org.robonewbie.competition.trial;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.robonewbie.competition.contest.ContestTrial;
import org.robonewbie.competition.contest.Ending;
import org.robonewbie.competition.contest.Entrant;
import org.robonewbie.competition.contest.Judge;
import org.robonewbie.competition.contest.JudgedContest;
import org.robonewbie.competition.contest.StartPlace;
import org.robonewbie.competition.contest.TeamResult;
import org.robonewbie.competition.contest.TrialResult;
import org.robonewbie.competition.team.Limits;
import org.robonewbie.competition.team.Start;
import org.robonewbie.competition.team.TeamProcess;
import org.robonewbie.competition.team.TeamProgram;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;

/**
 * Runs one trial: a simulator that waits for all programs and runs as fast as it can, and the programs of the teams. The world
 * begins when all are there, so that it does not matter how quickly a program starts.
 */
public final class TrialRunner implements TrialPlayer {

    private static final long LOOK_MILLISECONDS = 100;

    private final JudgedContest contest;
    private final Map<String, TeamProgram> programs;
    private final Limits limits;
    private final Spectators spectators;

    /**
     * Creates a runner.
     *
     * @param contest judges the trials
     * @param programs the program of each team
     * @param limits what programs may use
     * @param spectators who watches the trials live
     */
    public TrialRunner(JudgedContest contest, Map<String, TeamProgram> programs, Limits limits, Spectators spectators) {
        this.contest = contest;
        this.programs = Map.copyOf(programs);
        this.limits = limits;
        this.spectators = spectators;
    }

    @Override
    public TrialResult run(ContestTrial trial, TrialFiles files) throws IOException, InterruptedException {
        Judge judge = contest.judge(trial);
        Map<String, List<TeamProcess>> processes = new LinkedHashMap<>();
        try {
            Umpire umpire = play(trial, files, judge, processes);
            return result(trial, judge, umpire, processes);
        } finally {
            processes.values().stream().flatMap(List::stream).forEach(TeamProcess::close);
        }
    }

    /** Plays until the umpire has decided or the time is over. */
    private Umpire play(ContestTrial trial, TrialFiles files, Judge judge, Map<String, List<TeamProcess>> processes)
            throws IOException, InterruptedException {
        Path log = files.logs().resolve(trial.id() + "-simulator.txt");
        try (PrintWriter console = new PrintWriter(Files.newBufferedWriter(log, StandardCharsets.UTF_8), true);
                Simulator simulator = Simulator.start(settings(trial, files), console::println)) {
            Umpire umpire = new Umpire(trial, judge, simulator.control());
            simulator.control().addObserver(umpire);
            Runnable leaving = spectators.watch(simulator.control(), trial);
            try {
                startAll(trial, files, simulator, processes);
                lead(trial, simulator, umpire, processes);
            } finally {
                leaving.run();
            }
            return umpire;
        }
    }

    private SimulatorSettings settings(ContestTrial trial, TrialFiles files) {
        return SimulatorSettings.beginner()
                .parameters(trial.parameters())
                .agentPort(0)
                .synchronous(true)
                .speed(spectators.isNobody() ? SimulationControl.AS_FAST_AS_POSSIBLE : 1)
                .seed(trial.seed())
                .awaitedAgents(trial.robots() + 1)
                .silentAgentSeconds(limits.silentSeconds())
                .recording(files.recording())
                .build();
    }

    private void startAll(
            ContestTrial trial, TrialFiles files, Simulator simulator, Map<String, List<TeamProcess>> processes)
            throws IOException {
        for (Entrant entrant : trial.entrants()) {
            List<TeamProcess> own = new ArrayList<>();
            processes.put(entrant.team(), own);
            TeamProgram program = programs.get(entrant.team());
            if (program == null || program instanceof TeamProgram.Broken) {
                entrant.places().forEach(place -> StandIn.connect(simulator));
                continue;
            }
            for (Start start : starts(program, entrant, simulator.agentPort())) {
                String name = trial.id() + "-" + entrant.team() + (own.isEmpty() ? "" : "-" + (own.size() + 1));
                own.add(TeamProcess.start(
                        program,
                        start,
                        limits,
                        files.work().resolve(name),
                        files.logs().resolve(name + ".txt")));
            }
        }
        StandIn.connect(simulator); // keeps the clock running when all others are gone
    }

    private static List<Start> starts(TeamProgram program, Entrant entrant, int port) {
        boolean together = (program instanceof TeamProgram.OfJava java && java.together())
                || (program instanceof TeamProgram.OfCommand command && command.together());
        Stream<List<StartPlace>> groups = together
                ? Stream.of(entrant.places())
                : entrant.places().stream().map(List::of);
        return groups.map(places -> new Start(port, entrant.team(), entrant.role(), places))
                .toList();
    }

    /** Waits for the decision, and ensures that no program keeps the world from reaching it. */
    private void lead(ContestTrial trial, Simulator simulator, Umpire umpire, Map<String, List<TeamProcess>> processes)
            throws InterruptedException {
        long beginning = System.nanoTime();
        boolean tooLate = false;
        List<TeamProcess> gone = new ArrayList<>();
        while (!umpire.await(LOOK_MILLISECONDS)) {
            double seconds = (System.nanoTime() - beginning) / 1e9;
            for (List<TeamProcess> own : processes.values()) {
                own.forEach(TeamProcess::check);
                for (TeamProcess process : own) {
                    if (simulator.cycles() == 0 && !process.isRunning() && !gone.contains(process)) {
                        gone.add(process);
                        standInFor(trial, own, simulator);
                    }
                }
            }
            if (simulator.cycles() == 0 && seconds > limits.startSeconds() && !tooLate) {
                tooLate = true;
                for (int i = 0; i < trial.robots(); i++) {
                    StandIn.connect(simulator);
                }
            }
            if (seconds > limits.realSeconds()) {
                return;
            }
        }
    }

    /** Fills up for the robots of a process that has ended. */
    private static void standInFor(ContestTrial trial, List<TeamProcess> own, Simulator simulator) {
        int robots = trial.robots() / trial.entrants().size() / own.size();
        for (int i = 0; i < Math.max(1, robots); i++) {
            StandIn.connect(simulator);
        }
    }

    private TrialResult result(
            ContestTrial trial, Judge judge, Umpire umpire, Map<String, List<TeamProcess>> processes) {
        List<TeamResult> teams = new ArrayList<>();
        for (Entrant entrant : trial.entrants()) {
            String team = entrant.team();
            Ending ending = ending(team, umpire, processes.getOrDefault(team, List.of()));
            teams.add(TeamResult.of(team, ending, judge.figures(team)));
        }
        return new TrialResult(trial.id(), trial.seed(), rounded(umpire.seconds()), teams);
    }

    private Ending ending(String team, Umpire umpire, List<TeamProcess> processes) {
        if (programs.get(team) instanceof TeamProgram.Broken) {
            return Ending.NOT_COMPILED;
        }
        if (umpire.isGreedy(team)) {
            return Ending.TOO_MANY_ROBOTS;
        }
        if (umpire.isDecided() && umpire.isPresent(team)) {
            return Ending.PLAYED;
        }
        Ending reason = processes.stream()
                .map(process -> process.ending().orElse(Ending.SILENT))
                .findFirst()
                .orElse(Ending.NOT_STARTED);
        boolean unclear = reason == Ending.SILENT || reason == Ending.STOPPED;
        if (!umpire.isDecided()) {
            return reason == Ending.SILENT ? Ending.TOO_MUCH_TIME : reason;
        }
        return umpire.seconds() == 0 && unclear ? Ending.NOT_STARTED : reason;
    }

    private static double rounded(double seconds) {
        return Math.round(seconds * 100) / 100.0;
    }
}
