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
 * Starts the programs of one trial, and knows which may come through which door. In a sandbox a door is a file that only its team sees. Without,
 * it is a TCP port; on Linux the owner of a connection is known.
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
     * Prepares the doors of a trial.
     *
     * @param sandbox where programs run, if there is a sandbox
     * @param programs of all teams of the contest
     * @param limits what each may use
     * @param files where the trial puts what it writes
     * @param log takes what is noticed
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

    /** The file of a team's door; empty if it is a TCP port. */
    Optional<Path> file(String team) {
        return folder.map(place -> place.resolve(team));
    }

    /**
     * Starts a process of a team.
     *
     * @param start what it receives
     * @param name how the names of its files begin
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

    /** What a team does not see: the results, the programs of others. */
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

    /** The processes of a team in the order in which they have been started. */
    List<ChildProcess> processes(String team) {
        return processes.getOrDefault(team, List.of());
    }

    /** Why a program has ended, for whose end a moment is waited; empty if it is still running. */
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

    /** How a program has ended by itself. One that has just closed its connection is given a moment to end. */
    static OptionalInt exitCode(ChildProcess process) {
        process.awaitEnd(SECONDS_TO_END);
        return process.exitCode();
    }

    /** All processes. */
    List<ChildProcess> processes() {
        return processes.values().stream().flatMap(List::stream).toList();
    }

    /** Whether a connection may pass. Who tries another team's door is remembered. */
    boolean isWelcome(String team, int port, InetSocketAddress guest) {
        if (!ProcessTree.hasConnections() || isOf(team, port, guest)) {
            return true;
        }
        Optional<String> intruder = processes.keySet().stream()
                .filter(other -> !other.equals(team) && isOf(other, port, guest))
                .findFirst();
        intruder.ifPresent(intruders::add);
        log.accept("A connection to the port of " + team + " came from "
                + intruder.map(other -> "the program of " + other).orElse("no program of this trial")
                + " and was refused.");
        return false;
    }

    private boolean isOf(String team, int port, InetSocketAddress guest) {
        return processes(team).stream().anyMatch(process -> process.holds(guest.getPort(), port));
    }

    /** Teams whose programs tried the door of another one. */
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
