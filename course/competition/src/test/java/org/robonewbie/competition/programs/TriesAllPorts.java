package org.robonewbie.competition.programs;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** Wants to take the place of "Honest" at every port of this computer that waits for somebody, before it brings its own robot. */
public final class TriesAllPorts {

    private static final String LISTENING = "0A";

    private TriesAllPorts() {}

    /**
     * Starts the robot after the attack.
     *
     * @param args options of the robot
     */
    public static void main(String[] args) {
        int own = Integer.parseInt(List.of(args).get(List.of(args).indexOf("--port") + 1));
        ports().filter(port -> port != own).forEach(port -> {
            Thread thief = new Thread(() -> JoinsAsHonest.join(port));
            thief.setDaemon(true);
            thief.start();
        });
        Stands.main(args);
    }

    private static Stream<Integer> ports() {
        return Stream.of("/proc/net/tcp", "/proc/net/tcp6")
                .flatMap(TriesAllPorts::lines)
                .map(line -> line.strip().split("\\s+"))
                .filter(cells -> cells[3].equals(LISTENING))
                .map(cells -> Integer.parseInt(cells[1].replaceFirst(".*:", ""), 16))
                .distinct();
    }

    private static Stream<String> lines(String file) {
        try {
            return Files.readAllLines(Path.of(file)).stream();
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }
}
