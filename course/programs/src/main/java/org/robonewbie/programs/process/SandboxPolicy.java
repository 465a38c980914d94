package org.robonewbie.programs.process;

import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Optional;

/**
 * Permissions of a process in a {@link Sandbox}, in addition to reading system files.
 *
 * @param readable files and folders that the process may read
 * @param hidden files and folders that must be hidden from it, even if they are in a readable folder
 * @param files the program's folder, mounted at {@link Sandbox#FILES}
 * @param door the simulator's socket, or a folder of sockets
 * @param written a folder to which it may write
 */
public record SandboxPolicy(
        Collection<Path> readable,
        Collection<Path> hidden,
        Optional<Path> files,
        Optional<Path> door,
        Optional<Path> written) {

    /** Stores unmodifiable copies of the collections. */
    public SandboxPolicy {
        readable = List.copyOf(readable);
        hidden = List.copyOf(hidden);
    }
}
