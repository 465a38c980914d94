package org.robonewbie.studio.replay;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
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
        return world(cycle, random, Rotation.NONE);
    }

    private static WorldSnapshot world(int cycle, Random random, Rotation tilt) {
        List<RobotSnapshot> robots = new ArrayList<>();
        for (int i = 0; i < ROBOTS; i++) {
            RobotType type = RobotType.TYPE_0;
            double[] degrees =
                    random.doubles(NaoModel.of(type).hinges().size(), -90, 90).toArray();
            Pose torso = new Pose(new Vector3(i * 0.5 + cycle * 0.001, 1, 0.4), tilt);
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

    private static int count(RecordingIndex index) {
        return index.reading().summary().get("count").getAsInt();
    }

    @Test
    void piecesTogetherAreTheWholeRecording() throws IOException {
        Path file = restlessMatch(true);
        RecordingIndex index = read(file);
        List<String> whole = cyclesOf(unpacked(file), false);

        List<String> pieces = new ArrayList<>();
        List<Integer> starts = index.reading().pieces();
        for (int i = 0; i < starts.size(); i++) {
            assertThat(pieces).hasSize(starts.get(i));
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
        JsonObject first = read(file).reading().summary();

        RecordingIndex kept = RecordingIndex.open(file);

        assertThat(folder.resolve("match.index")).exists();
        assertThat(Files.readAllBytes(file)).as("the recording is unchanged").isEqualTo(recording);
        assertThat(kept.reading().whole()).isTrue();
        assertThat(kept.reading().summary()).isEqualTo(first);
        recording[recording.length - 6] ^= 1;
        Files.write(file, recording);
        assertThat(RecordingIndex.open(file).reading().whole()).isFalse();
    }

    @Test
    void damagedIndexIsRebuilt() throws IOException {
        Path file = restlessMatch(true);
        read(file);
        byte[] index = Files.readAllBytes(folder.resolve("match.index"));
        Files.write(folder.resolve("match.index"), Arrays.copyOf(index, index.length / 2));

        assertThat(RecordingIndex.open(file).reading().whole()).isFalse();
        assertThat(count(read(file))).isEqualTo(CYCLES);
    }

    @Test
    void summaryHasTeamsScoreEventsAndTrails() throws IOException {
        JsonObject summary = read(restlessMatch(true)).reading().summary();
        JsonArray ball = summary.remove("ball").getAsJsonArray();
        JsonArray ways = summary.remove("ways").getAsJsonArray();
        JsonArray rosters = summary.remove("rosters").getAsJsonArray();

        assertThat(summary)
                .hasToString("{'count':1500,'firstCycle':1,'left':'Stars','right':'Moons','score':[1,0],'robots':22,"
                        .concat("'pitch':[30.0,8.0],'events':[{'index':699,'kind':'goal','text':'left Stars'}],")
                        .concat("'header':{'FieldLength':'30'}}")
                        .replace('\'', '"'));
        assertThat(ball).hasSizeBetween(128, 256);
        assertThat(ball.get(0)).hasToString("[0.01,0.0]");
        assertThat(ways).hasSize(ROBOTS);
        assertThat(ways.get(21).getAsJsonObject().get("side").getAsInt()).isEqualTo(2);
        assertThat(rosters).hasSize(1);
    }

    @Test
    void robotThatFallsIsAnEvent() throws IOException {
        Path file = folder.resolve("fall.rec");
        try (RecordingWriter writer = RecordingWriter.open(RecordingFile.open(file, text -> {}), List.of())) {
            for (int cycle = 1; cycle <= 5; cycle++) {
                writer.write(world(cycle, new Random(5), Rotation.ofYawPitchRoll(0, 25 * cycle, 0)), List.of());
            }
        }

        JsonArray events = read(file).reading().summary().getAsJsonArray("events");

        assertThat(events).hasSize(ROBOTS);
        assertThat(events.get(0)).hasToString("{\"index\":2,\"kind\":\"fall\",\"text\":\"LEFT 1\"}");
    }

    @Test
    void recordingThatGrowsIsReadOn() throws IOException {
        Path whole = restlessMatch(false);
        byte[] bytes = Files.readAllBytes(whole);
        Path growing = Files.write(folder.resolve("now.rec.part"), Arrays.copyOf(bytes, bytes.length / 2));
        RecordingIndex index = read(growing);
        int before = count(index);

        Files.write(growing, bytes);
        assertThat(index.fits(growing)).isTrue();
        index.readOn(growing, 60_000);

        assertThat(before).isBetween(CYCLES / 3, 2 * CYCLES / 3);
        assertThat(count(index)).isGreaterThanOrEqualTo(CYCLES - 50);
        List<Integer> starts = index.reading().pieces();
        int last = starts.size() - 1;
        assertThat(cyclesOf(index.piece(growing, last, 0), true)).hasSize(count(index) - starts.get(last));
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
        assertThat(count(read(Files.writeString(folder.resolve("plain.rec"), "Hello"))))
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

        assertThat(index.reading().whole()).isTrue();
        assertThat(count(index)).isBetween(CYCLES / 4, CYCLES * 3 / 4);
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
