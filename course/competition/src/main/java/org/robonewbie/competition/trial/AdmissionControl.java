package org.robonewbie.competition.trial;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentSkipListSet;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import org.robonewbie.competition.contest.Ending;
import org.robonewbie.competition.team.Start;
import org.robonewbie.competition.team.TeamProgram;
import org.robonewbie.nao.file.TemporaryFiles;
import org.robonewbie.nao.file.TemporaryFolder;
import org.robonewbie.programs.process.ChildProcess;
import org.robonewbie.programs.process.Limits;
import org.robonewbie.programs.process.ProcessTree;
import org.robonewbie.programs.process.Sandbox;

/**
 * Admission control of one trial: starts the programs and decides which of them may connect to which port. In a sandbox, each
 * team's port is a Unix domain socket that is visible only to this team. Without a sandbox it is a TCP port; on Linux,
 * connections are accepted only from the team's processes.
 */
final class AdmissionControl implements AutoCloseable {

    private static final double SECONDS_TO_END = 4;

    private final Sandbox sandbox;
    private final Map<String, TeamProgram> programs;
    private final Limits limits;
    private final TrialFiles files;
    private final Consumer<String> log;
    private final Optional<Path> folder;
    private final Map<String, List<ChildProcess>> processes = new ConcurrentHashMap<>();
    private final List<Path> workFolders = new CopyOnWriteArrayList<>();
    private final Set<String> intruders = new ConcurrentSkipListSet<>();

    /**
     * Creates the ports of a trial.
     *
     * @param sandbox sandbox for the programs
     * @param programs programs of all teams in the contest
     * @param limits resource limits per program
     * @param files output files of the trial
     * @param log receives reports of refused connections
     */
    AdmissionControl(
            Sandbox sandbox, Map<String, TeamProgram> programs, Limits limits, TrialFiles files, Consumer<String> log)
            throws IOException {
        this.sandbox = sandbox;
        this.programs = programs;
        this.limits = limits;
        this.files = files;
        this.log = log;
        this.folder = sandbox.isUp() ? Optional.of(TemporaryFiles.folder("doors")) : Optional.empty();
    }

    /** Returns the file of a team's Unix domain socket; empty if its port is a TCP port. */
    Optional<Path> file(String team) {
        return folder.map(place -> place.resolve(team));
    }

    /**
     * Starts a process for a team.
     *
     * @param start arguments of the program
     * @param name prefix for the names of the process's files
     * @throws IOException if it cannot be started
     */
    ChildProcess start(Start start, String name) throws IOException {
        String team = start.team();
        List<ChildProcess> all = processes.computeIfAbsent(team, first -> new CopyOnWriteArrayList<>());
        String own = name + (all.isEmpty() ? "" : "-" + (all.size() + 1));
        Path work = files.work().resolve(own);
        ChildProcess process = Objects.requireNonNull(programs.get(team))
                .start(
                        start,
                        limits,
                        new TeamProgram.Surroundings(sandbox, file(team), hidden(team)),
                        work,
                        files.logs().resolve(own + ".txt"));
        workFolders.add(work);
        all.add(process);
        return process;
    }

    /** Returns the paths that are hidden from a team: the results and the programs of other teams. */
    private List<Path> hidden(String team) {
        List<Path> unseen = new ArrayList<>(files.hidden());
        programs.forEach((other, program) -> {
            if (!other.equals(team)) {
                unseen.addAll(program.places());
            }
        });
        Optional.ofNullable(programs.get(team)).ifPresent(own -> unseen.removeAll(own.places()));
        return unseen;
    }

    /** Returns a team's processes in the order in which they were started. */
    List<ChildProcess> processes(String team) {
        return processes.getOrDefault(team, List.of());
    }

    /** Returns why a program has ended, after waiting briefly for its exit; empty if it is still running. */
    static Optional<Ending> ending(ChildProcess process) {
        boolean hasEnded = process.excess().isPresent() || process.awaitEnd(SECONDS_TO_END);
        return hasEnded
                ? Optional.of(process.excess().map(AdmissionControl::ending).orElse(Ending.STOPPED))
                : Optional.empty();
    }

    private static Ending ending(ChildProcess.Excess limit) {
        return switch (limit) {
            case PROCESSES -> Ending.TOO_MANY_PROCESSES;
            case MEMORY -> Ending.TOO_MUCH_MEMORY;
            case PROCESSOR_TIME -> Ending.TOO_MUCH_TIME;
            case SILENCE -> Ending.SILENT;
        };
    }

    /** Returns a program's exit code, after waiting briefly for its exit. */
    static OptionalInt exitCode(ChildProcess process) {
        process.awaitEnd(SECONDS_TO_END);
        return process.exitCode();
    }

    List<ChildProcess> processes() {
        return processes.values().stream().flatMap(List::stream).toList();
    }

    /** Returns whether a connection is allowed. A team that connects to another team's port is recorded as an intruder. */
    boolean isAllowed(String team, int port, InetSocketAddress client) {
        if (!ProcessTree.hasConnections() || isOf(team, port, client)) {
            return true;
        }
        Optional<String> intruder = processes.keySet().stream()
                .filter(other -> !other.equals(team) && isOf(other, port, client))
                .findFirst();
        intruder.ifPresent(intruders::add);
        log.accept("A connection to the port of " + team + " came from "
                + intruder.map(other -> "the program of " + other).orElse("a program outside this trial")
                + " and was refused.");
        return false;
    }

    private boolean isOf(String team, int port, InetSocketAddress client) {
        return processes(team).stream().anyMatch(process -> process.holds(client.getPort(), port));
    }

    /** Returns the teams whose programs connected to another team's port. */
    Set<String> intruders() {
        return intruders;
    }

    @Override
    public void close() {
        processes().forEach(ChildProcess::close);
        workFolders.forEach(TemporaryFolder::delete);
        folder.ifPresent(TemporaryFolder::delete);
    }
}
