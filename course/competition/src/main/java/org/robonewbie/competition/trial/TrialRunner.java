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
 * Runs one trial: a simulator that waits for all programs and runs as fast as it can, and the programs of the teams. The world
 * begins when all are there, so that it does not matter how quickly a program starts.
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
     * @param contest judges the trials
     * @param programs the program of each team
     * @param limits what programs may use
     * @param sandbox where programs run, if there is a sandbox
     * @param spectators who watches the trials live
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
        List<String> noticed = new CopyOnWriteArrayList<>();
        try (AdmissionControl doorkeeper = new AdmissionControl(sandbox, programs, limits, files, noticed::add)) {
            return play(trial, files, judge, doorkeeper);
        } finally {
            files.tell(trial.id(), noticed);
        }
    }

    /** Plays until the umpire has decided or the time is over. */
    private TrialResult play(ContestTrial trial, TrialFiles files, Judge judge, AdmissionControl doorkeeper)
            throws IOException, InterruptedException {
        Path log = files.logs().resolve(trial.id() + "-simulator.txt");
        AtomicReference<Simulator> running = new AtomicReference<>();
        List<TeamEndpoint> endpoints = trial.entrants().stream()
                .map(entrant -> endpoint(entrant, doorkeeper, running))
                .toList();
        try (PrintWriter console = new PrintWriter(Files.newBufferedWriter(log, StandardCharsets.UTF_8), true);
                Simulator simulator = Simulator.start(settings(trial, files, endpoints), console::println)) {
            running.set(simulator);
            TrialSupervisor umpire =
                    new TrialSupervisor(trial, judge, simulator.control(), simulator::robotsOf, doorkeeper.intruders());
            simulator.control().addObserver(umpire);
            Runnable leaving = spectators.watch(simulator.control(), trial);
            try {
                startAll(trial, simulator, doorkeeper);
                lead(trial, simulator, umpire, doorkeeper);
            } finally {
                leaving.run();
            }
            return result(trial, judge, umpire, simulator, doorkeeper);
        }
    }

    /** Creates the endpoint of a team. The programs start after the simulator, so that none connects before it runs. */
    private static TeamEndpoint endpoint(
            Entrant entrant, AdmissionControl doorkeeper, AtomicReference<Simulator> running) {
        String team = entrant.team();
        return new TeamEndpoint(
                team,
                entrant.places().size(),
                doorkeeper.file(team),
                guest -> Optional.ofNullable(running.get())
                        .map(simulator -> doorkeeper.isWelcome(team, simulator.agentPort(team), guest))
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

    private void startAll(ContestTrial trial, Simulator simulator, AdmissionControl doorkeeper) throws IOException {
        for (Entrant entrant : trial.entrants()) {
            String team = entrant.team();
            TeamProgram program = programs.get(team);
            if (program == null || program instanceof TeamProgram.Broken) {
                entrant.places().forEach(place -> StandIn.connect(simulator));
                continue;
            }
            for (Start start : starts(program, entrant, simulator.agentPort(team))) {
                doorkeeper.start(start, trial.id() + "-" + team);
            }
        }
        StandIn.connect(simulator); // keeps the clock running when all others are gone
    }

    private static List<Start> starts(TeamProgram program, Entrant entrant, int port) {
        Stream<List<StartPlace>> groups = program.together()
                ? Stream.of(entrant.places())
                : entrant.places().stream().map(List::of);
        return groups.map(places -> new Start(port, entrant.team(), entrant.role(), places))
                .toList();
    }

    /** Waits for the decision, and ensures that no program keeps the world from reaching it. */
    private void lead(ContestTrial trial, Simulator simulator, TrialSupervisor umpire, AdmissionControl doorkeeper)
            throws InterruptedException {
        long beginning = System.nanoTime();
        boolean tooLate = false;
        Set<ChildProcess> gone = new HashSet<>();
        while (!umpire.await(LOOK_MILLISECONDS)) {
            double seconds = (System.nanoTime() - beginning) / 1e9;
            if (simulator.cycles() == 0) {
                replaceTheGone(trial, simulator, doorkeeper, gone);
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

    /** The world does not wait for programs that have ended before it began. */
    private static void replaceTheGone(
            ContestTrial trial, Simulator simulator, AdmissionControl doorkeeper, Set<ChildProcess> gone) {
        for (Entrant entrant : trial.entrants()) {
            List<ChildProcess> own = doorkeeper.processes(entrant.team());
            for (ChildProcess process : own) {
                if (!process.isRunning() && gone.add(process)) {
                    standInFor(trial, own, simulator);
                }
            }
        }
    }

    /** Fills up for the robots of a process that has ended. */
    private static void standInFor(ContestTrial trial, List<ChildProcess> own, Simulator simulator) {
        int robots = trial.robots() / trial.entrants().size() / own.size();
        for (int i = 0; i < Math.max(1, robots); i++) {
            StandIn.connect(simulator);
        }
    }

    private TrialResult result(
            ContestTrial trial, Judge judge, TrialSupervisor umpire, Simulator simulator, AdmissionControl doorkeeper) {
        List<TeamResult> teams = new ArrayList<>();
        for (Entrant entrant : trial.entrants()) {
            String team = entrant.team();
            Ending ending = ending(team, umpire, simulator, doorkeeper);
            OptionalInt exitCode = doorkeeper.processes(team).stream()
                    .filter(process -> ending == Ending.STOPPED)
                    .map(AdmissionControl::exitCode)
                    .findFirst()
                    .orElse(OptionalInt.empty());
            teams.add(TeamResult.of(team, ending, judge.figures(team)).withExitCode(exitCode));
        }
        return new TrialResult(trial.id(), trial.seed(), rounded(umpire.seconds()), teams);
    }

    private Ending ending(String team, TrialSupervisor umpire, Simulator simulator, AdmissionControl doorkeeper) {
        if (programs.get(team) instanceof TeamProgram.Broken broken) {
            return broken.ending();
        }
        if (doorkeeper.intruders().contains(team)) {
            return Ending.INTRUDED;
        }
        if (umpire.isGreedy(team)) {
            return Ending.TOO_MANY_ROBOTS;
        }
        if (umpire.isDecided() && umpire.isPresent(team)) {
            return Ending.PLAYED;
        }
        if (simulator.wasSilent(team)) {
            return Ending.SILENT;
        }
        Ending reason = doorkeeper.processes(team).stream()
                .map(process -> AdmissionControl.ending(process).orElse(Ending.SILENT))
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
