package org.robonewbie.programs.process;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** Reads information about processes and their connections from Linux's {@code /proc}. */
final class LinuxProcess {

    private static final int PAGE_BYTES = 4096;

    private static final int INODE = 9;
    private static final Path PROCESSES = Path.of("/proc");
    private static final List<Path> CONNECTIONS = List.of(Path.of("/proc/net/tcp"), Path.of("/proc/net/tcp6"));

    private LinuxProcess() {}

    /** Returns the resident memory of a process in bytes; 0 if unknown. */
    static long residentBytes(long pid) {
        String text = read(Path.of("/proc", String.valueOf(pid), "statm"));
        return text.isEmpty() ? 0 : Long.parseLong(text.split(" ", -1)[1]) * PAGE_BYTES;
    }

    /** Returns whether a thread of a process is runnable or waiting for the disk; false if unknown. */
    static boolean isAtWork(long pid) {
        return entries(PROCESSES.resolve(pid + "/task")).stream()
                .map(thread -> read(thread.resolve("stat")))
                .anyMatch(stat -> {
                    int state = stat.lastIndexOf(')') + 2; // after the name, which may contain any character
                    return state < stat.length() && "RD".indexOf(stat.charAt(state)) >= 0;
                });
    }

    /** Returns whether the system reports which process owns a connection. */
    static boolean hasConnections() {
        return Files.isReadable(CONNECTIONS.get(0)) && Files.isDirectory(PROCESSES.resolve("self/fd"));
    }

    /**
     * Finds the socket at one end of a local connection.
     *
     * @param ownPort port of this end
     * @param otherPort port of the other end
     * @return the name that identifies the socket in file descriptors, such as {@code socket:[4711]}; empty if there is
     *     none
     */
    static Optional<String> socket(int ownPort, int otherPort) {
        String own = String.format(":%04X", ownPort);
        String other = String.format(":%04X", otherPort);
        return CONNECTIONS.stream()
                .flatMap(file -> read(file).lines())
                .map(line -> line.strip().split("\\s+"))
                .filter(cells -> cells.length > INODE && cells[1].endsWith(own) && cells[2].endsWith(other))
                .map(cells -> "socket:[" + cells[INODE] + "]")
                .findFirst();
    }

    /** Returns whether a process holds a socket. */
    static boolean holds(long pid, String socket) {
        return entries(PROCESSES.resolve(pid + "/fd")).stream()
                .anyMatch(file -> target(file).equals(socket));
    }

    /**
     * Finds processes, including daemons, by their inherited environment or their working directory.
     *
     * @param mark text that the environment of a process must contain
     * @param folder working directory or a parent of it; empty if other programs may also use it
     * @return process identifiers
     */
    static List<Long> marked(String mark, Optional<Path> folder) {
        return entries(PROCESSES).stream()
                .filter(process -> String.valueOf(process.getFileName()).matches("\\d+"))
                .filter(process -> folder.filter(own -> worksIn(process, own)).isPresent()
                        || read(process.resolve("environ")).contains(mark))
                .map(process -> Long.valueOf(String.valueOf(process.getFileName())))
                .toList();
    }

    private static boolean worksIn(Path process, Path folder) {
        String own = target(process.resolve("cwd"));
        return own.equals(folder.toString()) || own.startsWith(folder + "/");
    }

    private static String target(Path link) {
        try {
            return Files.readSymbolicLink(link).toString();
        } catch (IOException gone) {
            return "";
        }
    }

    /** Returns the entries of a folder; an empty list if it does not exist. */
    private static List<Path> entries(Path folder) {
        try (Stream<Path> entries = Files.list(folder)) {
            return entries.toList();
        } catch (IOException | UncheckedIOException gone) {
            return List.of();
        }
    }

    private static String read(Path file) {
        try {
            return new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1);
        } catch (IOException gone) {
            return "";
        }
    }
}
