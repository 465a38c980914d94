package org.robonewbie.competition.team;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** What Linux tells about a process; other systems do not tell it. */
final class LinuxProcess {

    private static final int PAGE_BYTES = 4096;

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

    private static List<Path> threads(long pid) {
        try (Stream<Path> threads = Files.list(Path.of("/proc", String.valueOf(pid), "task"))) {
            return threads.toList();
        } catch (IOException gone) {
            return List.of();
        }
    }

    private static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException gone) {
            return "";
        }
    }
}
