package org.robonewbie.studio.monitor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.file.RecordingFile;
import org.robonewbie.simulator.monitor.RecordedLog;
import org.robonewbie.simulator.recording.RecordedCycle;
import org.robonewbie.simulator.recording.RecordingReader;

/** Reads logs of a real rcssserver3d. */
class MonitorLogReaderTest {

    private static final Path ORIGINAL = Path.of(
            "../../core/protocol/src/test/resources/org/robonewbie/protocol/monitor/g_monitor_first_and_50_updates.txt.gz");

    @TempDir
    private Path folder;

    private List<RecordedCycle> convert(Path log) throws IOException {
        Path recording = folder.resolve("log.rec");
        MonitorLogReader.convert(log, recording);
        List<RecordedCycle> cycles = new ArrayList<>();
        try (RecordingReader reader = RecordingFile.read(recording)) {
            assertThat(reader.header()).containsEntry("FieldLength", "30.0");
            for (Optional<RecordedCycle> cycle = reader.next(); cycle.isPresent(); cycle = reader.next()) {
                cycles.add(cycle.get());
            }
        }
        return cycles;
    }

    @Test
    void logOfTheOriginalBecomesARecording() throws IOException {
        List<RecordedCycle> cycles = convert(ORIGINAL);

        WorldSnapshot last = cycles.get(cycles.size() - 1).snapshot();
        assertThat(cycles).hasSizeGreaterThan(90);
        assertThat(last.playMode()).isEqualTo(PlayMode.PLAY_ON);
        assertThat(last.gameTime()).isCloseTo(0.78, within(1e-6));
        assertThat(last.teamLeft()).isEqualTo("X");
        assertThat(cycles).anyMatch(cycle -> cycle.snapshot().ballPosition().x() > 1);
        assertThat(cycles).anyMatch(cycle -> cycle.events().contains("playmode PlayOn"));
    }

    @Test
    void jointsOfTheOriginalFollowFromItsLimbs() throws IOException {
        List<RecordedCycle> cycles = convert(ORIGINAL);
        int neck = NaoModel.of(RobotType.TYPE_0).hingeIndex(Joint.NECK_YAW);
        int knee = NaoModel.of(RobotType.TYPE_0).hingeIndex(Joint.LEFT_KNEE_PITCH);

        List<Double> yaws = cycles.stream()
                .map(cycle -> cycle.snapshot().robots().get(0).body().hingeDegrees()[neck])
                .toList();

        assertThat(yaws).anyMatch(yaw -> Math.abs(yaw) > 2).allMatch(yaw -> Math.abs(yaw) < 30);
        for (int i = 1; i < yaws.size(); i++) {
            assertThat(yaws.get(i)).isCloseTo(yaws.get(i - 1), within(3.0));
        }
        assertThat(cycles)
                .allMatch(cycle ->
                        Math.abs(cycle.snapshot().robots().get(0).body().hingeDegrees()[knee]) < 2);
    }

    @Test
    void drawingsInFrontOfAMessageAreSkipped() throws IOException {
        Path log = folder.resolve("roboviz.log");
        List<String> lines = new ArrayList<>();
        for (String line : PackedText.lines(ORIGINAL)) {
            lines.add("[1, 2, 34, 50][0, 0, 97, 0]" + line);
        }
        Files.write(log, lines);

        assertThat(convert(log)).hasSizeGreaterThan(90);
    }

    @Test
    void recordingSurvivesTheRoundTripThroughALog() throws IOException {
        List<RecordedCycle> first = convert(ORIGINAL);
        Path log = folder.resolve("again.log");
        RecordedLog.write(folder.resolve("log.rec"), log);

        List<RecordedCycle> again = convert(log);

        WorldSnapshot last = again.get(again.size() - 1).snapshot();
        WorldSnapshot same = first.stream()
                .map(RecordedCycle::snapshot)
                .filter(state -> Math.abs(state.gameTime() - last.gameTime()) < 1e-6)
                .reduce((one, other) -> other)
                .orElseThrow();
        assertThat(last.teamLeft()).isEqualTo("X");
        assertThat(last.playMode()).isEqualTo(same.playMode());
        for (int i = 0; i < 22; i++) {
            assertThat(last.robots().get(0).body().hingeDegrees()[i])
                    .isCloseTo(same.robots().get(0).body().hingeDegrees()[i], within(1.5));
        }
    }

    @Test
    void otherFilesAreRefused() throws IOException {
        Path file = Files.writeString(folder.resolve("letter.txt"), "Dear robot,\n((nonsense\n");

        assertThatThrownBy(() -> MonitorLogReader.convert(file, folder.resolve("none.rec")))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("is not a server log: it contains no complete scene.");
        assertThat(folder.resolve("none.rec")).doesNotExist();
    }
}
