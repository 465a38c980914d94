package org.robonewbie.competition.programs;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;

/** Looks where it should not, and tells on its output what it could do. */
public final class Snoops {

    private static final int MEGABYTES = 1000;

    private Snoops() {}

    /** Something that can fail. */
    private interface Deed {
        void dare() throws IOException;
    }

    /**
     * Tries everything, then brings the robot.
     *
     * @param args options of the robot; what it looks at stands in the file {@code targets} of its folder
     */
    public static void main(String[] args) throws IOException {
        for (String line : Files.readAllLines(Path.of("targets"))) {
            Path target = Path.of(line.substring(line.indexOf(' ') + 1));
            Map<String, Deed> deeds = Map.of(
                    "read", () -> Files.readAllBytes(target),
                    "write", () -> Files.writeString(target, "mine"),
                    "port", () -> connect(Integer.parseInt(target.toString())));
            String verb = line.substring(0, line.indexOf(' '));
            tell(line, deeds.getOrDefault(verb, () -> {}));
        }
        tell("fill the disk", Snoops::fillTheDisk);
        tell("write at home", () -> Files.writeString(Path.of("note"), "mine"));
        System.out.println("own file: " + Files.readString(Path.of("own")));
        System.out.println("strangers: "
                + ProcessHandle.allProcesses()
                        .filter(process -> process.info().arguments().stream()
                                .flatMap(Arrays::stream)
                                .anyMatch(word -> word.contains("ForkedBooter") || word.contains("RunTests")))
                        .count());
        Stands.main(args);
    }

    private static void connect(int port) throws IOException {
        try (Socket socket = new Socket()) {
            socket.connect(new InetSocketAddress(InetAddress.getLoopbackAddress(), port), 1000);
        }
    }

    private static void fillTheDisk() throws IOException {
        byte[] megabyte = new byte[1 << 20];
        Path heap = Path.of("heap");
        try (var file = Files.newOutputStream(heap)) {
            for (int i = 0; i < MEGABYTES; i++) {
                file.write(megabyte);
            }
        } finally {
            Files.deleteIfExists(heap);
        }
    }

    private static void tell(String what, Deed deed) {
        try {
            deed.dare();
            System.out.println("could " + what);
        } catch (IOException refused) {
            System.out.println("could not " + what);
        }
    }
}
