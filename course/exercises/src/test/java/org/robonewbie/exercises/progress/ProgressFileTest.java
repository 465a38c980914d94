package org.robonewbie.exercises.progress;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;

class ProgressFileTest {

    private static final Instant NOON = Instant.parse("2026-11-22T12:00:00Z");
    private static final Exercise KICK = Exercises.find("kick").orElseThrow();

    @TempDir
    private Path folder;

    private ProgressFile file() {
        return new ProgressFile(folder.resolve("of").resolve("progress.json"));
    }

    @Test
    void bestPointsTriesAndTheTimeOfWorkAreKept() throws IOException {
        file().update(KICK, state -> state.seen(NOON));
        file().update(KICK, state -> state.tried(7, false, NOON.plusSeconds(300)));
        file().update(KICK, state -> state.tried(4, false, NOON.plus(Duration.ofHours(3))));
        file().update(
                        KICK,
                        state -> state.tried(
                                9, true, NOON.plus(Duration.ofHours(3)).plusSeconds(60)));
        file().update(
                        KICK,
                        state -> state.tried(
                                2, false, NOON.plus(Duration.ofHours(3)).plusSeconds(90)));

        ExerciseProgress kick = file().read().of(KICK);

        assertThat(kick.tries()).isEqualTo(4);
        assertThat(kick.bestPoints()).isEqualTo(9);
        assertThat(kick.passed()).isTrue();
        assertThat(kick.seconds())
                .as("without the pause, and until it was passed")
                .isEqualTo(360);
    }

    @Test
    void thereIsNoProgressBeforeTheFirstTry() throws IOException {
        assertThat(file().read().exercises()).isEmpty();
        assertThat(file().read().of(KICK)).isEqualTo(ExerciseProgress.NONE);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "hello",
                "[]",
                "{\"exercises\":7}",
                "{\"exercises\":{\"kick\":[]}}",
                "{\"exercises\":{\"kick\":{\"tries\":\"many\"}}}",
                "{\"exercises\":{\"kick\":{\"tries\":-3,\"bestPoints\":1e9,\"lastSeen\":\"yesterday\"}}}"
            })
    void nonsenseCostsNoMoreThanItself(String nonsense) throws IOException {
        Path path = file().file();
        Files.createDirectories(folder.resolve("of"));
        Files.writeString(path, nonsense);

        assertThat(file().read().of(KICK).bestPoints()).isBetween(0.0, 10.0);
        file().update(KICK, state -> state.tried(5, true, NOON));

        assertThat(file().read().of(KICK).passed()).isTrue();
    }

    @Test
    void damagedFileIsPutAside() throws IOException {
        Path path = file().file();
        Files.createDirectories(folder.resolve("of"));
        Files.write(path, new byte[] {(byte) 0xff, 0, (byte) 0xc3});

        file().update(KICK, state -> state.tried(5, true, NOON));

        assertThat(Files.readAllBytes(path.resolveSibling("progress.json.damaged")))
                .containsExactly(0xff, 0, 0xc3);
    }

    @Test
    void nothingIsLostWhenTwoProgramsWriteAtTheSameTime() throws Exception {
        ExecutorService programs = Executors.newFixedThreadPool(2);
        List<Future<ExerciseProgress>> done = new ArrayList<>();
        for (int i = 0; i < 20; i++) {
            done.add(programs.submit(() -> file().update(KICK, state -> state.tried(5, false, NOON))));
        }
        for (Future<ExerciseProgress> each : done) {
            each.get();
        }
        programs.shutdown();

        assertThat(file().read().of(KICK).tries()).isEqualTo(20);
    }

    @Test
    void teamHasTheBestOfItsMembers() throws IOException {
        ProgressFile other = new ProgressFile(folder.resolve("ben.json"));
        file().update(KICK, state -> state.tried(4, false, NOON));
        other.update(KICK, state -> state.tried(8, true, NOON));

        Progress team = file().read().joined(other.read());

        assertThat(team.of(KICK).bestPoints()).isEqualTo(8);
        assertThat(team.passed()).isEqualTo(1);
        assertThat(team.badges()).contains(Badge.FIRST_SUCCESS).doesNotContain(Badge.WHOLE_COURSE);
        assertThat(file().read().badges()).isEmpty();
    }

    /** Saves its progress without an end, and prints a line for each time. */
    static final class SavesProgress {

        public static void main(String[] arguments) throws IOException {
            ProgressFile file = new ProgressFile(Path.of(arguments[0]));
            while (true) {
                ExerciseProgress state = file.update(KICK, before -> before.tried(3, false, NOON));
                System.out.println(state.tries());
            }
        }
    }

    @Tag("slow")
    @Timeout(60)
    @ParameterizedTest
    @ValueSource(ints = {1, 20, 100, 301})
    void whoIsKilledWhileSavingLeavesTheFormerProgressOrTheNewOne(int saves) throws Exception {
        Process process = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-cp",
                        System.getProperty("java.class.path"),
                        SavesProgress.class.getName(),
                        file().file().toString())
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        int told = 0;
        try (BufferedReader lines = process.inputReader()) {
            while (told < saves) {
                told = Integer.parseInt(lines.readLine());
            }
            assertThat(process.toHandle().destroyForcibly()).isTrue();
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                told = Integer.parseInt(line);
            }
        }

        assertThat(file().isDamaged()).isFalse();
        assertThat(file().read().of(KICK).tries()).isBetween(told, told + 1);
        assertThat(file().update(KICK, before -> before.tried(3, false, NOON)).tries())
                .isGreaterThan(told);
        assertThat(file().damagedFile()).doesNotExist();
    }
}
