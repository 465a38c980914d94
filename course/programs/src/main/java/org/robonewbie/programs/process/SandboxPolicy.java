package org.robonewbie.programs.process;

import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Optional;

/**
 * What a process may do in a {@link Sandbox} beside using the system.
 *
 * @param readable what it may read, at its usual place
 * @param hidden what it must not see, even within something readable
 * @param files the program's folder, shown at {@link Sandbox#FILES}
 * @param door the socket at which the simulator listens, or a folder of such
 * @param written a folder in which it may write
 */
public record SandboxPolicy(
        Collection<Path> readable,
        Collection<Path> hidden,
        Optional<Path> files,
        Optional<Path> door,
        Optional<Path> written) {

    /** Copies the collections. */
    public SandboxPolicy {
        readable = List.copyOf(readable);
        hidden = List.copyOf(hidden);
    }
}
