package org.robonewbie.simulator.recording;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.zip.GZIPInputStream;
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
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.landscape.Thing;
import org.robonewbie.simulator.recording.RecordingState.Listener;

class ThingRecordingTest {

    /** What a version that knew of no things wrote of these ten cycles. */
    private static final String HASH_OF_BARE_PITCH = "1c05110a739e57cc21fe7356ad06065728d330fff9d13cca18aaecf52fb588c4";

    @TempDir
    private Path folder;

    private static WorldSnapshot moment(int cycle, List<Thing> things) {
        double[] degrees = new double[NaoModel.of(RobotType.TYPE_0).hinges().size()];
        degrees[3] = cycle;
        Pose torso = new Pose(new Vector3(-3 + 0.01 * cycle, 0.5, 0.39), Rotation.NONE);
        RobotSnapshot robot = new RobotSnapshot(
                1, "Stars", Optional.of(TeamSide.LEFT), 7, BodyState.ofHinges(RobotType.TYPE_0, torso, degrees));
        return new WorldSnapshot(
                cycle,
                0.02 * cycle,
                PlayMode.PLAY_ON,
                "Stars",
                "",
                0,
                0,
                1,
                new Vector3(0, 0.02 * cycle, 0.042),
                Rotation.NONE,
                List.of(robot),
                things,
                false,
                1,
                1);
    }

    /** A box that stands for three cycles, then moves and turns. */
    private static List<Thing> things(int cycle) {
        List<Thing> things = new ArrayList<>(Landscape.SLOPE.things());
        Thing box = Landscape.BOX.things().get(0);
        int moved = Math.max(0, cycle - 3);
        things.add(box.at(
                new Pose(new Vector3(-3.2 + 0.05 * moved, 0, 0.2), Rotation.about(new Vector3(0, 0, 1), 10 * moved))));
        return things;
    }

    private static void write(RecordingWriter writer, boolean bare) {
        for (int cycle = 1; cycle <= 10; cycle++) {
            writer.write(moment(cycle, bare ? List.of() : things(cycle)), List.of());
        }
    }

    private Path file() throws IOException {
        Path file = folder.resolve("run.rec");
        try (RecordingWriter writer =
                RecordingWriter.open(RecordingFile.open(file, sentence -> {}), List.of("scene=slope"))) {
            write(writer, false);
        }
        return file;
    }

    @Test
    void recordingOfABarePitchIsWhatItWasBeforeThereWereThings() {
        try (RecordingWriter writer = RecordingWriter.open(RecordingTarget.NONE, List.of("seed=1"))) {
            write(writer, true);

            assertThat(writer.sha256()).isEqualTo(HASH_OF_BARE_PITCH);
        }
    }

    @Test
    void readerShowsThingsAsTheyWere() throws IOException {
        try (RecordingReader reader = RecordingFile.read(file())) {
            for (int cycle = 1; cycle <= 10; cycle++) {
                List<Thing> read = reader.next().orElseThrow().snapshot().things();
                List<Thing> written = things(cycle);
                assertThat(read).extracting(Thing::name).containsExactly("slope", "top", "step", "step", "box");
                assertThat(read).extracting(Thing::massKg).containsExactly(0.0, 0.0, 0.0, 0.0, 4.0);
                for (int i = 0; i < read.size(); i++) {
                    assertThat(read.get(i).size().distanceTo(written.get(i).size()))
                            .isLessThan(2e-4);
                    assertThat(read.get(i).centre().distanceTo(written.get(i).centre()))
                            .isLessThan(2e-4);
                }
                assertThat(read.get(4).pose().rotation().yawDegrees())
                        .isCloseTo(10.0 * Math.max(0, cycle - 3), within(0.02));
            }
            assertThat(reader.next()).isEmpty();
        }
    }

    @Test
    void restingThingsCostNothing() throws IOException {
        List<Integer> kinds = new ArrayList<>();
        byte[] bytes = unpacked(file());
        RecordCursor cursor = new RecordCursor(bytes, 0, bytes.length);
        cursor.skip(RecordingFormat.MAGIC.length() + 1);
        while (!cursor.isAtEnd()) {
            kinds.add(cursor.getByte());
            cursor.skip(cursor.getUnsigned());
        }

        assertThat(kinds).filteredOn(kind -> kind == RecordingFormat.THINGS).hasSize(1);
        assertThat(kinds)
                .filteredOn(kind -> kind == RecordingFormat.MOVED_THING)
                .hasSize(7);
    }

    @Test
    void whoBeginsInTheMiddleKnowsWhereThingsAre() throws IOException {
        byte[] bytes = unpacked(file());
        int half = endOfCycle(bytes, 6);
        RecordingState state = new RecordingState(nobody());
        state.push(bytes, half);
        byte[] start = state.toRecords();

        RecordingState late = new RecordingState(nobody());
        byte[] head = Arrays.copyOf(bytes, RecordingFormat.MAGIC.length() + 1);
        late.push(head, head.length);
        late.push(start, start.length);
        byte[] rest = Arrays.copyOfRange(bytes, half, bytes.length);
        late.push(rest, rest.length);
        state.push(rest, rest.length);

        assertThat(late.toRecords()).isEqualTo(state.toRecords());
        assertThat(start).isNotEqualTo(state.toRecords());
    }

    @Test
    void thingThatDoesNotExistCannotMove() {
        ByteSink payload = new ByteSink();
        payload.putUnsigned(3);
        RecordCursor content = new RecordCursor(payload.bytes(), 0, payload.length());

        assertThatThrownBy(() -> ThingTrack.readMoved(Landscape.BOX.things(), content))
                .isInstanceOf(IndexOutOfBoundsException.class);
    }

    private static byte[] unpacked(Path file) throws IOException {
        try (GZIPInputStream in = new GZIPInputStream(Files.newInputStream(file))) {
            return in.readAllBytes();
        }
    }

    private static int endOfCycle(byte[] bytes, int wanted) {
        RecordCursor cursor = new RecordCursor(bytes, 0, bytes.length);
        cursor.skip(RecordingFormat.MAGIC.length() + 1);
        for (int cycles = 0; cycles < wanted; ) {
            cycles += cursor.getByte() == RecordingFormat.CYCLE ? 1 : 0;
            cursor.skip(cursor.getUnsigned());
        }
        return cursor.position();
    }

    private static Listener nobody() {
        return new Listener() {
            @Override
            public void happened(String text) {}

            @Override
            public void cycleEnded(long cycle, RecordingState state) {}
        };
    }
}
