package org.robonewbie.competition.team;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * What encloses the process of a program: a fence with a door, or nothing.
 *
 * @param fence the fence, which may be down
 * @param door the file of the socket at which the simulator waits for the team; empty without fence
 * @param hidden what nobody within the fence sees: the programs of others, the results
 */
public record Enclosure(Fence fence, Optional<Path> door, Collection<Path> hidden) {

    /** Nothing around the process: it has the rights of whoever holds the competition. */
    public static final Enclosure OPEN = new Enclosure(Fence.none(""), Optional.empty(), List.of());

    /** Copies the collection. */
    public Enclosure {
        hidden = List.copyOf(hidden);
    }

    /**
     * Returns the port that the program is told.
     *
     * @param outside TCP port of the simulator outside the fence
     * @return the port as it is seen from here
     */
    public int port(int outside) {
        return door.isPresent() ? Fence.PORT : outside;
    }

    Path temporary(Path workFolder) {
        return door.isPresent() ? Path.of("/tmp") : workFolder;
    }

    /** Puts the fence around a command. */
    List<String> around(List<String> command, TeamProgram program) {
        if (door.isEmpty()) {
            return command;
        }
        List<Path> readable =
                new ArrayList<>(ProgramCommand.classPathOf(program).readable());
        if (program instanceof TeamProgram.OfCommand other) {
            other.files().forEach(file -> readable.add(besides(file)));
        } else if (program instanceof TeamProgram.OfJava java) {
            readable.addAll(java.readable());
        }
        return fence.enclose(command, readable, hidden, program.folder(), door.get());
    }

    /** A script may need its neighbours; but not if these are other teams, or all that somebody has. */
    private Path besides(Path file) {
        Path folder = Objects.requireNonNullElse(file.getParent(), file);
        boolean foreign = hidden.stream().anyMatch(other -> other.startsWith(folder))
                || Path.of(System.getProperty("user.home")).startsWith(folder);
        return Files.isDirectory(file) || foreign ? file : folder;
    }
}
