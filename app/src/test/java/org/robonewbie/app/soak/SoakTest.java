package org.robonewbie.app.soak;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.simulator.file.RecordingFile;
import org.robonewbie.simulator.recording.RecordedCycle;
import org.robonewbie.simulator.recording.RecordingReader;

/**
 * Eleven honest robots play for long, while eleven others crash, fall silent, flood the server and come back, and monitors never read. Nobody
 * honest loses a cycle, memory stays level, and the recording is whole, also when the disk is full in the middle.
 *
 * <p>The nightly run has {@code -Dsoak.simulated-seconds=21600 -Dsoak.clock-seconds=1800}: six hours simulated, half an hour on the clock.
 */
@Tag("slow")
@EnabledOnOs(OS.LINUX)
class SoakTest {

    private static final int ROBOTS = 11;
    private static final int LOOKS = 8;
    private static final int LIVES = 20;
    private static final int MAX_CYCLES_OF_A_LIFE = 4000;
    private static final double SECONDS = Double.parseDouble(System.getProperty("soak.simulated-seconds", "30"));
    private static final double CLOCK_SECONDS = Double.parseDouble(System.getProperty("soak.clock-seconds", "12"));
    private static final long MAX_KILOBYTES = 1L << 40;
    private static final double RECORDED_KILOBYTES_PER_SECOND = 8;
    private static final long MAX_MORE_MEGABYTES = 20;
    private static final long MAX_MORE_FILES = 60;

    @TempDir
    private Path folder;

    /** What the server takes at some moment. */
    private record Look(long megabytes, long files) {}

    private final List<Look> looks = new CopyOnWriteArrayList<>();

    @Test
    void honestRobotsLoseNothingInFastModeAlsoWhenTheDiskIsFull() throws Exception {
        long room = Math.round(SECONDS / 2 * RECORDED_KILOBYTES_PER_SECOND);
        Path recording = folder.resolve("full.rec");
        List<String> said;

        try (SoakServer server = server(room, SECONDS, recording, "--fast", "--drop-silent-after", "2")) {
            assertNobodyHonestLoses(server, SECONDS);
            said = server.sentences();
        }

        System.out.println("soak: recorded bytes " + Files.size(AtomicFile.part(recording)));
        assertThat(said).anyMatch(line -> line.contains("ends here because it cannot be written"));
        assertThat(recording).doesNotExist();
        assertThat(recordedCycles(AtomicFile.part(recording))).isBetween(cycles(SECONDS) / 8, cycles(SECONDS) - 1);
    }

    @Test
    void honestRobotsLoseNothingOnTheClock() throws Exception {
        Path recording = folder.resolve("clock.rec");

        try (SoakServer server = server(MAX_KILOBYTES, CLOCK_SECONDS, recording)) {
            assertNobodyHonestLoses(server, CLOCK_SECONDS);
        }

        assertThat(recordedCycles(recording)).isBetween(cycles(CLOCK_SECONDS) - 1, cycles(CLOCK_SECONDS) + 1);
        String report = Files.readString(folder.resolve("report.json"));
        assertThat(JsonParser.parseString(report)
                        .getAsJsonObject()
                        .get("simulatedSeconds")
                        .getAsDouble())
                .isGreaterThanOrEqualTo(CLOCK_SECONDS);
    }

    private SoakServer server(long kilobytes, double seconds, Path recording, String... more) throws IOException {
        List<String> options = new ArrayList<>(List.of(more));
        options.addAll(
                List.of("--seed", "1", "--seconds", Double.toString(seconds), "--wait-for", "22", "--no-trainers"));
        options.addAll(List.of("--record", recording.toString()));
        options.addAll(List.of("--report", folder.resolve("report.json").toString()));
        return new SoakServer(kilobytes, options.toArray(String[]::new));
    }

    private void assertNobodyHonestLoses(SoakServer server, double seconds) throws Exception {
        ExecutorService threads = Executors.newCachedThreadPool();
        List<Future<HonestRobot.Count>> honest = new ArrayList<>();
        List<Future<Integer>> rogues = new ArrayList<>();
        int mostCycles = (int) Math.min(MAX_CYCLES_OF_A_LIFE, cycles(seconds) / LIVES);
        try {
            for (int number = 1; number <= ROBOTS; number++) {
                HonestRobot.Listener listener = number == 1
                        ? heard -> lookFromTimeToTime(server, heard, cycles(seconds), threads)
                        : heard -> {};
                honest.add(threads.submit(new HonestRobot(server.agentPort(), number, listener)));
                rogues.add(threads.submit(new Rogue(server.agentPort(), server.monitorPort(), number, mostCycles)));
            }
            assertThat(server.awaitEnd()).isZero();
            assertCounts(honest, rogues, cycles(seconds));
        } finally {
            threads.shutdownNow();
        }
    }

    private void assertCounts(List<Future<HonestRobot.Count>> honest, List<Future<Integer>> rogues, long cycles)
            throws InterruptedException, ExecutionException {
        int lives = 0;
        for (Future<Integer> rogue : rogues) {
            lives += rogue.get();
        }
        for (Future<HonestRobot.Count> robot : honest) {
            assertThat(robot.get().lost()).isZero();
            assertThat(robot.get().heard()).isGreaterThan(cycles - 20);
        }
        System.out.println("soak: " + cycles + " cycles, " + lives + " lives of rogues, " + looks);
        assertThat(lives).isGreaterThan(2 * ROBOTS);
        Look first = looks.get(0);
        Look last = looks.get(looks.size() - 1);
        assertThat(looks).hasSizeGreaterThanOrEqualTo(LOOKS - 2);
        assertThat(last.megabytes()).isLessThanOrEqualTo(first.megabytes() + MAX_MORE_MEGABYTES);
        assertThat(last.files()).isLessThanOrEqualTo(first.files() + MAX_MORE_FILES);
    }

    /** The first and the last eighth of the time are left out; nobody waits for the look. */
    private void lookFromTimeToTime(SoakServer server, long heard, long cycles, ExecutorService threads) {
        if (heard % (cycles / LOOKS) == 0 && heard < cycles - cycles / LOOKS / 2) {
            threads.execute(() -> look(server));
        }
    }

    private void look(SoakServer server) {
        try {
            looks.add(new Look(server.megabytes(), server.openFiles()));
        } catch (IOException ended) {
            // The server was faster; there are enough other looks.
        }
    }

    private static long cycles(double seconds) {
        return Math.round(seconds / Cycle.SECONDS);
    }

    /** Reads a recording to its end; its cycles follow each other. */
    private static long recordedCycles(Path file) throws IOException {
        try (RecordingReader reader = RecordingFile.read(file)) {
            long count = 0;
            long last = 0;
            for (Optional<RecordedCycle> cycle = reader.next(); cycle.isPresent(); cycle = reader.next()) {
                long number = cycle.get().snapshot().cycle();
                assertThat(number).isEqualTo(count == 0 ? number : last + 1);
                last = number;
                count++;
            }
            return count;
        }
    }
}
