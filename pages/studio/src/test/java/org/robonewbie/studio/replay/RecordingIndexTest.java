package org.robonewbie.studio.replay;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.file.RecordingFile;
import org.robonewbie.simulator.recording.RecordingState;
import org.robonewbie.simulator.recording.RecordingWriter;

class RecordingIndexTest {

    private static final int CYCLES = 1500;
    private static final int ROBOTS = 22;

    @TempDir
    private Path folder;

    /** A run in which every joint moves in every cycle. */
    private Path restlessMatch(boolean ends) throws IOException {
        Path file = folder.resolve("match.rec");
        Random random = new Random(5);
        RecordingWriter writer = RecordingWriter.open(RecordingFile.open(file, text -> {}), List.of("FieldLength=30"));
        for (int cycle = 1; cycle <= CYCLES; cycle++) {
            writer.write(world(cycle, random), cycle == 700 ? List.of("goal left Stars") : List.of());
        }
        if (ends) {
            writer.close();
            return file;
        }
        return folder.resolve("match.rec.part");
    }

    private static WorldSnapshot world(int cycle, Random random) {
        List<RobotSnapshot> robots = new ArrayList<>();
        for (int i = 0; i < ROBOTS; i++) {
            RobotType type = RobotType.TYPE_0;
            double[] degrees =
                    random.doubles(NaoModel.of(type).hinges().size(), -90, 90).toArray();
            Pose torso = new Pose(new Vector3(i * 0.5 + cycle * 0.001, 1, 0.4), Rotation.NONE);
            TeamSide side = i < 11 ? TeamSide.LEFT : TeamSide.RIGHT;
            robots.add(new RobotSnapshot(
                    i, side.name(), Optional.of(side), i % 11 + 1, BodyState.ofHinges(type, torso, degrees)));
        }
        Vector3 ball = new Vector3(cycle * 0.01, 0, 0.04);
        return new WorldSnapshot(
                cycle,
                cycle * 0.02,
                PlayMode.PLAY_ON,
                "Stars",
                "Moons",
                cycle < 700 ? 0 : 1,
                0,
                1,
                ball,
                Rotation.NONE,
                robots,
                List.of(),
                false,
                1,
                1);
    }

    private static RecordingIndex read(Path file) throws IOException {
        RecordingIndex index = RecordingIndex.open(file);
        index.readOn(file, 60_000);
        return index;
    }

    @Test
    void piecesTogetherAreTheWholeRecording() throws IOException {
        Path file = restlessMatch(true);
        RecordingIndex index = read(file);
        List<String> whole = cyclesOf(unpacked(file), false);

        List<String> pieces = new ArrayList<>();
        int[] starts = index.firstMoments();
        for (int i = 0; i < starts.length; i++) {
            assertThat(pieces).hasSize(starts[i]);
            pieces.addAll(cyclesOf(index.piece(file, i, 0), i > 0));
        }

        assertThat(starts).hasSizeGreaterThan(3);
        assertThat(pieces).hasSize(CYCLES).isEqualTo(whole);
    }

    @Test
    void restOfAPieceIsGivenAlone() throws IOException {
        Path file = restlessMatch(true);
        RecordingIndex index = read(file);
        byte[] piece = index.piece(file, 1, 0);

        assertThat(index.piece(file, 1, 1000)).isEqualTo(Arrays.copyOfRange(piece, 1000, piece.length));
        assertThat(index.piece(file, 1, piece.length)).isEmpty();
        assertThat(index.piece(file, 99, 0)).isEmpty();
    }

    @Test
    void indexIsKeptBesideALargeRecordingAndFitsOnlyThatOne() throws IOException {
        Path file = restlessMatch(true);
        byte[] recording = Files.readAllBytes(file);
        RunSummary first = read(file).summary();

        RecordingIndex kept = RecordingIndex.open(file);

        assertThat(folder.resolve("match.index")).exists();
        assertThat(Files.readAllBytes(file)).as("the recording is unchanged").isEqualTo(recording);
        assertThat(kept.isWhole()).isTrue();
        assertThat(kept.summary()).isEqualTo(first);
        recording[recording.length - 6] ^= 1;
        Files.write(file, recording);
        assertThat(RecordingIndex.open(file).isWhole()).isFalse();
    }

    @Test
    void damagedIndexIsRebuilt() throws IOException {
        Path file = restlessMatch(true);
        read(file);
        byte[] index = Files.readAllBytes(folder.resolve("match.index"));
        Files.write(folder.resolve("match.index"), Arrays.copyOf(index, index.length / 2));

        assertThat(RecordingIndex.open(file).isWhole()).isFalse();
        assertThat(read(file).summary().count()).isEqualTo(CYCLES);
    }

    @Test
    void summaryHasTeamsScoreEventsAndTrails() throws IOException {
        RunSummary summary = read(restlessMatch(true)).summary();

        assertThat(summary.count()).isEqualTo(CYCLES);
        assertThat(summary.firstCycle()).isEqualTo(1);
        assertThat(List.of(summary.left(), summary.right())).containsExactly("Stars", "Moons");
        assertThat(summary.score()).containsExactly(1, 0);
        assertThat(summary.robots()).isEqualTo(ROBOTS);
        assertThat(summary.events()).containsExactly(new RunSummary.Event(699, "goal", "left Stars"));
        assertThat(summary.ball()).hasSizeBetween(128, 256);
        assertThat(summary.ball().get(0)).containsExactly(0.01, 0.0);
        assertThat(summary.ways()).hasSize(ROBOTS);
        assertThat(summary.ways().get(21).side()).isEqualTo(2);
        assertThat(summary.rosters()).hasSize(1);
    }

    @Test
    void recordingThatGrowsIsReadOn() throws IOException {
        Path whole = restlessMatch(false);
        byte[] bytes = Files.readAllBytes(whole);
        Path growing = Files.write(folder.resolve("now.rec.part"), Arrays.copyOf(bytes, bytes.length / 2));
        RecordingIndex index = read(growing);
        int before = index.summary().count();

        Files.write(growing, bytes);
        assertThat(index.fits(growing)).isTrue();
        index.readOn(growing, 60_000);

        assertThat(before).isBetween(CYCLES / 3, 2 * CYCLES / 3);
        assertThat(index.summary().count()).isGreaterThanOrEqualTo(CYCLES - 50);
        int last = index.firstMoments().length - 1;
        assertThat(cyclesOf(index.piece(growing, last, 0), true))
                .hasSize(index.summary().count() - index.firstMoments()[last]);
        assertThat(folder.resolve("now.index")).doesNotExist();
    }

    @Test
    void otherFilesAreRefused() throws IOException {
        Path file = folder.resolve("text.rec");
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (GZIPOutputStream out = new GZIPOutputStream(packed)) {
            out.write("Hello, this is quite another kind of file.".getBytes(StandardCharsets.UTF_8));
        }
        Files.write(file, packed.toByteArray());

        assertThatThrownBy(() -> read(file))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("not a recording of version 1");
        assertThat(read(Files.writeString(folder.resolve("plain.rec"), "Hello"))
                        .summary()
                        .count())
                .isZero();
    }

    @Test
    void damagedRecordingIsReadAsFarAsItIsGood() throws IOException {
        Path file = restlessMatch(true);
        byte[] bytes = unpacked(file);
        Arrays.fill(bytes, bytes.length / 2, bytes.length / 2 + 2000, (byte) 0xFF);
        try (GZIPOutputStream out = new GZIPOutputStream(Files.newOutputStream(file))) {
            out.write(bytes);
        }

        RecordingIndex index = read(file);

        assertThat(index.isWhole()).isTrue();
        assertThat(index.summary().count()).isBetween(CYCLES / 4, CYCLES * 3 / 4);
    }

    private static byte[] unpacked(Path file) throws IOException {
        try (InputStream in = new GZIPInputStream(new ByteArrayInputStream(Files.readAllBytes(file)))) {
            return in.readAllBytes();
        }
    }

    /** The content of each cycle; a later piece is appended to the header of an empty recording. */
    private static List<String> cyclesOf(byte[] bytes, boolean isLater) {
        List<String> cycles = new ArrayList<>();
        RecordingState state = new RecordingState(new RecordingState.Listener() {
            @Override
            public void happened(String text) {}

            @Override
            public void cycleEnded(long cycle, RecordingState now) {
                cycles.add(cycle + " " + now.ball(0) + " " + now.score()
                        + now.robots().stream()
                                .map(robot -> now.number(robot, 0) + "/" + now.number(robot, 7 + 21))
                                .toList());
            }
        });
        if (isLater) {
            byte[] begin = "RoboNewbie recording\n\u0001".getBytes(StandardCharsets.US_ASCII);
            state.push(begin, begin.length);
        }
        state.push(bytes, bytes.length);
        return cycles;
    }
}
