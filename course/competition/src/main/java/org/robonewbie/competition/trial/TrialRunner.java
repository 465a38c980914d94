package org.robonewbie.competition.trial;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Stream;
import org.robonewbie.competition.contest.ContestTrial;
import org.robonewbie.competition.contest.Ending;
import org.robonewbie.competition.contest.Entrant;
import org.robonewbie.competition.contest.Judge;
import org.robonewbie.competition.contest.JudgedContest;
import org.robonewbie.competition.contest.StartPlace;
import org.robonewbie.competition.contest.TeamResult;
import org.robonewbie.competition.contest.TrialResult;
import org.robonewbie.competition.team.Start;
import org.robonewbie.competition.team.TeamProgram;
import org.robonewbie.programs.process.ChildProcess;
import org.robonewbie.programs.process.Limits;
import org.robonewbie.programs.process.Sandbox;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;
import org.robonewbie.simulator.server.TeamEndpoint;

/**
 * Runs trials in a full simulator: starts the simulator and the teams' programs. The clock starts when all robots have
 * joined, so it does not matter how long the programs take to start.
 */
public final class TrialRunner implements TrialPlayer {

    private static final long LOOK_MILLISECONDS = 100;

    private final JudgedContest contest;
    private final Map<String, TeamProgram> programs;
    private final Limits limits;
    private final Sandbox sandbox;
    private final Spectators spectators;

    /**
     * Creates a runner.
     *
     * @param contest the contest, which supplies the judges
     * @param programs programs by team name
     * @param limits resource limits per program
     * @param sandbox sandbox for the programs
     * @param spectators live viewers
     */
    public TrialRunner(
            JudgedContest contest,
            Map<String, TeamProgram> programs,
            Limits limits,
            Sandbox sandbox,
            Spectators spectators) {
        this.contest = contest;
        this.programs = Map.copyOf(programs);
        this.limits = limits;
        this.sandbox = sandbox;
        this.spectators = spectators;
    }

    @Override
    public TrialResult run(ContestTrial trial, TrialFiles files) throws IOException, InterruptedException {
        Judge judge = contest.judge(trial);
        List<String> notices = new CopyOnWriteArrayList<>();
        try (AdmissionControl admission = new AdmissionControl(sandbox, programs, limits, files, notices::add)) {
            return play(trial, files, judge, admission);
        } finally {
            files.writeNotices(trial.id(), notices);
        }
    }

    /** Runs a trial until it is decided or the time limit is reached. */
    private TrialResult play(ContestTrial trial, TrialFiles files, Judge judge, AdmissionControl admission)
            throws IOException, InterruptedException {
        Path log = files.logs().resolve(trial.id() + "-simulator.txt");
        AtomicReference<Simulator> running = new AtomicReference<>();
        List<TeamEndpoint> endpoints = trial.entrants().stream()
                .map(entrant -> endpoint(entrant, admission, running))
                .toList();
        try (PrintWriter console = new PrintWriter(Files.newBufferedWriter(log, StandardCharsets.UTF_8), true);
                Simulator simulator = Simulator.start(settings(trial, files, endpoints), console::println)) {
            running.set(simulator);
            TrialSupervisor supervisor =
                    new TrialSupervisor(trial, judge, simulator.control(), simulator::robotsOf, admission.intruders());
            simulator.control().addObserver(supervisor);
            Runnable leaving = spectators.watch(simulator.control(), trial);
            try {
                startAll(trial, simulator, admission);
                supervise(trial, simulator, supervisor, admission);
            } finally {
                leaving.run();
            }
            return result(trial, judge, supervisor, simulator, admission);
        }
    }

    /** Creates a team's endpoint. Programs are started after the simulator, so no connection arrives before the simulator is running. */
    private static TeamEndpoint endpoint(
            Entrant entrant, AdmissionControl admission, AtomicReference<Simulator> running) {
        String team = entrant.team();
        return new TeamEndpoint(
                team,
                entrant.places().size(),
                admission.file(team),
                client -> Optional.ofNullable(running.get())
                        .map(simulator -> admission.isAllowed(team, simulator.agentPort(team), client))
                        .orElse(false));
    }

    private SimulatorSettings settings(ContestTrial trial, TrialFiles files, List<TeamEndpoint> endpoints) {
        return SimulatorSettings.of(WorldSettings.beginner()
                        .withParameters(trial.parameters())
                        .withSeed(trial.seed()))
                .withAgents(new SimulatorSettings.Agents(
                        SimulatorSettings.LOCALHOST, 0, endpoints, trial.robots() + 1, limits.silentSeconds()))
                .withSpeed(spectators.isNobody() ? SimulationControl.AS_FAST_AS_POSSIBLE : 1)
                .withOutput(files.recording(), Optional.empty());
    }

    private void startAll(ContestTrial trial, Simulator simulator, AdmissionControl admission) throws IOException {
        for (Entrant entrant : trial.entrants()) {
            String team = entrant.team();
            TeamProgram program = programs.get(team);
            if (program == null || program instanceof TeamProgram.Broken) {
                entrant.places().forEach(place -> StandIn.connect(simulator));
                continue;
            }
            for (Start start : starts(program, entrant, simulator.agentPort(team))) {
                admission.start(start, trial.id() + "-" + team);
            }
        }
        StandIn.connect(simulator); // keeps the clock running when all other agents have left
    }

    private static List<Start> starts(TeamProgram program, Entrant entrant, int port) {
        Stream<List<StartPlace>> groups = program.together()
                ? Stream.of(entrant.places())
                : entrant.places().stream().map(List::of);
        return groups.map(places -> new Start(port, entrant.team(), entrant.role(), places))
                .toList();
    }

    /** Waits until the trial is decided. Connects stand-ins for programs that would otherwise block the simulator. */
    private void supervise(
            ContestTrial trial, Simulator simulator, TrialSupervisor supervisor, AdmissionControl admission)
            throws InterruptedException {
        long startNanos = System.nanoTime();
        boolean timedOut = false;
        Set<ChildProcess> ended = new HashSet<>();
        while (!supervisor.await(LOOK_MILLISECONDS)) {
            double seconds = (System.nanoTime() - startNanos) / 1e9;
            if (simulator.cycles() == 0) {
                replaceEnded(trial, simulator, admission, ended);
            }
            if (simulator.cycles() == 0 && seconds > limits.startSeconds() && !timedOut) {
                timedOut = true;
                for (int i = 0; i < trial.robots(); i++) {
                    StandIn.connect(simulator);
                }
            }
            if (seconds > limits.realSeconds()) {
                return;
            }
        }
    }

    /** Connects stand-ins for programs that ended before the clock started. */
    private static void replaceEnded(
            ContestTrial trial, Simulator simulator, AdmissionControl admission, Set<ChildProcess> ended) {
        for (Entrant entrant : trial.entrants()) {
            List<ChildProcess> own = admission.processes(entrant.team());
            for (ChildProcess process : own) {
                if (!process.isRunning() && ended.add(process)) {
                    standInFor(trial, own, simulator);
                }
            }
        }
    }

    /** Connects a stand-in for each robot of a process that has ended. */
    private static void standInFor(ContestTrial trial, List<ChildProcess> own, Simulator simulator) {
        int robots = trial.robots() / trial.entrants().size() / own.size();
        for (int i = 0; i < Math.max(1, robots); i++) {
            StandIn.connect(simulator);
        }
    }

    private TrialResult result(
            ContestTrial trial,
            Judge judge,
            TrialSupervisor supervisor,
            Simulator simulator,
            AdmissionControl admission) {
        List<TeamResult> teams = new ArrayList<>();
        for (Entrant entrant : trial.entrants()) {
            String team = entrant.team();
            Ending ending = ending(team, supervisor, simulator, admission);
            OptionalInt exitCode = admission.processes(team).stream()
                    .filter(process -> ending == Ending.STOPPED)
                    .map(AdmissionControl::exitCode)
                    .findFirst()
                    .orElse(OptionalInt.empty());
            teams.add(TeamResult.of(team, ending, judge.figures(team)).withExitCode(exitCode));
        }
        return new TrialResult(trial.id(), trial.seed(), rounded(supervisor.seconds()), teams);
    }

    private Ending ending(String team, TrialSupervisor supervisor, Simulator simulator, AdmissionControl admission) {
        if (programs.get(team) instanceof TeamProgram.Broken broken) {
            return broken.ending();
        }
        if (admission.intruders().contains(team)) {
            return Ending.INTRUDED;
        }
        if (supervisor.hasTooManyRobots(team)) {
            return Ending.TOO_MANY_ROBOTS;
        }
        if (supervisor.isDecided() && supervisor.isPresent(team)) {
            return Ending.PLAYED;
        }
        if (simulator.wasSilent(team)) {
            return Ending.SILENT;
        }
        Ending reason = admission.processes(team).stream()
                .map(process -> AdmissionControl.ending(process).orElse(Ending.SILENT))
                .findFirst()
                .orElse(Ending.NOT_STARTED);
        boolean unclear = reason == Ending.SILENT || reason == Ending.STOPPED;
        if (!supervisor.isDecided()) {
            return reason == Ending.SILENT ? Ending.TOO_MUCH_TIME : reason;
        }
        return supervisor.seconds() == 0 && unclear ? Ending.NOT_STARTED : reason;
    }

    private static double rounded(double seconds) {
        return Math.round(seconds * 100) / 100.0;
    }
}
