package org.robonewbie.competition.trial;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentSkipListSet;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import org.robonewbie.competition.team.Enclosure;
import org.robonewbie.competition.team.Fence;
import org.robonewbie.competition.team.ProcessTree;
import org.robonewbie.competition.team.TeamFolder;
import org.robonewbie.competition.team.TeamProcess;
import org.robonewbie.competition.team.TeamProgram;
import org.robonewbie.nao.file.TemporaryFiles;

/**
 * Knows which program may come through which door in one trial. Behind a fence a door is a file that only its team sees. Without,
 * it is a TCP port; whose connection comes there, Linux tells, and elsewhere nobody.
 */
final class Doorkeeper implements AutoCloseable {

    private final Fence fence;
    private final Map<String, TeamProgram> programs;
    private final Collection<Path> hidden;
    private final Consumer<String> log;
    private final Optional<Path> folder;
    private final Map<String, List<TeamProcess>> processes = new ConcurrentHashMap<>();
    private final Set<String> intruders = new ConcurrentSkipListSet<>();

    /**
     * Prepares the doors of a trial.
     *
     * @param fence the fence
     * @param programs of all teams of the contest
     * @param hidden what no program within a fence sees, beside the programs of others
     * @param log takes what is noticed
     */
    Doorkeeper(Fence fence, Map<String, TeamProgram> programs, Collection<Path> hidden, Consumer<String> log)
            throws IOException {
        this.fence = fence;
        this.programs = programs;
        this.hidden = hidden;
        this.log = log;
        this.folder = fence.isUp() ? Optional.of(TemporaryFiles.folder("doors")) : Optional.empty();
    }

    /** The file of a team's door; empty if it is a TCP port. */
    Optional<Path> file(String team) {
        return folder.map(place -> place.resolve(team));
    }

    /** What encloses the processes of a team. */
    Enclosure enclosure(String team) {
        List<Path> unseen = new ArrayList<>(hidden);
        programs.forEach((other, program) -> {
            if (!other.equals(team)) {
                unseen.addAll(program.places());
            }
        });
        Optional.ofNullable(programs.get(team)).ifPresent(own -> unseen.removeAll(own.places()));
        return new Enclosure(fence, file(team), unseen);
    }

    /** Notes a process of a team. */
    void started(String team, TeamProcess process) {
        processes.computeIfAbsent(team, name -> new CopyOnWriteArrayList<>()).add(process);
    }

    /** The processes of a team in the order in which they have been started. */
    List<TeamProcess> processes(String team) {
        return processes.getOrDefault(team, List.of());
    }

    /** All processes. */
    List<TeamProcess> processes() {
        return processes.values().stream().flatMap(List::stream).toList();
    }

    /** Whether a connection may pass. Who tries another team's door is remembered. */
    boolean isWelcome(String team, int port, InetSocketAddress guest) {
        if (!ProcessTree.knowsConnections() || isOf(team, port, guest)) {
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
        processes().forEach(TeamProcess::close);
        folder.ifPresent(TeamFolder::delete);
    }
}
