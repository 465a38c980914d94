package org.robonewbie.programs.process;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** What Linux tells about processes and their connections; other systems do not tell it. */
final class LinuxProcess {

    private static final int PAGE_BYTES = 4096;

    private static final int INODE = 9;
    private static final Path PROCESSES = Path.of("/proc");
    private static final List<Path> CONNECTIONS = List.of(Path.of("/proc/net/tcp"), Path.of("/proc/net/tcp6"));

    private LinuxProcess() {}

    /** Memory that a process takes; 0 where it is not known. */
    static long residentBytes(long pid) {
        String text = read(Path.of("/proc", String.valueOf(pid), "statm"));
        return text.isEmpty() ? 0 : Long.parseLong(text.split(" ", -1)[1]) * PAGE_BYTES;
    }

    /** Whether a thread of a process runs, or waits for nothing but a processor or the disk; false where it is not known. */
    static boolean isAtWork(long pid) {
        return threads(pid).stream().map(thread -> read(thread.resolve("stat"))).anyMatch(stat -> {
            int state = stat.lastIndexOf(')') + 2; // behind a name that may have anything in it
            return state < stat.length() && "RD".indexOf(stat.charAt(state)) >= 0;
        });
    }

    /** Whether this system tells whose a connection is. */
    static boolean hasConnections() {
        return Files.isReadable(CONNECTIONS.get(0)) && Files.isDirectory(PROCESSES.resolve("self/fd"));
    }

    /**
     * Finds the socket of one end of a connection within this computer.
     *
     * @param ownPort port of this end
     * @param otherPort port of the other end
     * @return the socket as processes hold it, such as {@code socket:[4711]}; empty if there is none
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

    /** Whether a process holds a socket. */
    static boolean holds(long pid, String socket) {
        try (Stream<Path> files = Files.list(PROCESSES.resolve(pid + "/fd"))) {
            return files.anyMatch(file -> target(file).equals(socket));
        } catch (IOException gone) {
            return false;
        }
    }

    /**
     * Finds processes by what they have inherited, also those that have left their parents.
     *
     * @param mark what stands in the environment of each
     * @param folder where they work, or in a folder of it; empty if others may work there, too
     * @return their numbers
     */
    static List<Long> marked(String mark, Optional<Path> folder) {
        try (Stream<Path> processes = Files.list(PROCESSES)) {
            return processes
                    .filter(process -> String.valueOf(process.getFileName()).matches("\\d+"))
                    .filter(process ->
                            folder.filter(own -> worksIn(process, own)).isPresent()
                                    || read(process.resolve("environ")).contains(mark))
                    .map(process -> Long.valueOf(String.valueOf(process.getFileName())))
                    .toList();
        } catch (IOException otherSystem) {
            return List.of();
        }
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

    private static List<Path> threads(long pid) {
        try (Stream<Path> threads = Files.list(Path.of("/proc", String.valueOf(pid), "task"))) {
            return threads.toList();
        } catch (IOException gone) {
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
