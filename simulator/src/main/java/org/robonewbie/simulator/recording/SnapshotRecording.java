package org.robonewbie.simulator.recording;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.WorldSnapshot;

/**
 * Writes a recording of a world of which only states are known, such as the log of another server: it can be shown again like a
 * run of our own, but knows no commands.
 */
public final class SnapshotRecording implements AutoCloseable {

    private final RecordingStream stream;
    private final RecordSink sink;
    private final DeltaTrack ballTrack = new DeltaTrack(RecordingFormat.NUMBERS_PER_POSE);
    private final Map<Integer, DeltaTrack> robotTracks = new HashMap<>();
    private String lastRobots = "";
    private long lastPlayTicks;

    private SnapshotRecording(RecordingStream stream) {
        this.stream = stream;
        this.sink = new RecordSink(stream);
    }

    /**
     * Begins a recording.
     *
     * @param file where it goes; the name appears when the recording is closed
     * @param header lines of the form {@code name=value} that describe the run, such as the measures of the pitch
     * @param console takes sentences for people
     * @return the recording, still empty
     * @throws IOException if the file cannot be written; the message says what to do
     */
    public static SnapshotRecording open(Path file, List<String> header, Consumer<String> console) throws IOException {
        SnapshotRecording recording = new SnapshotRecording(RecordingStream.open(Optional.of(file), console));
        recording.sink.begin(header);
        return recording;
    }

    /**
     * Writes one cycle.
     *
     * @param snapshot the world at its end
     * @param events what happened, such as {@code goal left Stars}
     */
    public void write(WorldSnapshot snapshot, List<String> events) {
        events.forEach(sink::putEvent);
        sink.putGame(
                snapshot.playMode(),
                snapshot.half(),
                snapshot.scoreLeft(),
                snapshot.scoreRight(),
                snapshot.teamLeft(),
                snapshot.teamRight());
        writeRobots(snapshot.robots());
        writeCycle(snapshot);
        sink.send();
    }

    @Override
    public void close() {
        stream.close();
    }

    private void writeRobots(List<RobotSnapshot> robots) {
        ByteSink payload = sink.newPayload();
        payload.putUnsigned(robots.size());
        for (RobotSnapshot robot : robots) {
            payload.putUnsigned(robot.id());
            payload.putUnsigned(robot.type().ordinal());
            payload.putUnsigned(robot.side().map(TeamSide::ordinal).orElse(-1) + 1);
            payload.putUnsigned(robot.number());
            payload.putText(robot.team());
        }
        String now = new String(payload.bytes(), 0, payload.length(), StandardCharsets.ISO_8859_1);
        if (!now.equals(lastRobots)) {
            lastRobots = now;
            sink.put(RecordingFormat.ROBOTS);
        }
    }

    private void writeCycle(WorldSnapshot state) {
        ByteSink payload = sink.newPayload();
        payload.putUnsigned(state.cycle());
        long playTicks = Math.round(state.gameTime() / WorldSnapshot.CYCLE_SECONDS);
        payload.putSigned(playTicks - lastPlayTicks);
        lastPlayTicks = playTicks;
        float[] turn = state.ballOrientation();
        float[] ball = {
            (float) state.ballPosition().x(),
            (float) state.ballPosition().y(),
            (float) state.ballPosition().z(),
            turn[0],
            turn[1],
            turn[2],
            turn[3]
        };
        ballTrack.putPose(0, ball, 0, payload);
        state.robots().forEach(robot -> writeRobot(robot, payload));
        sink.put(RecordingFormat.CYCLE);
    }

    private void writeRobot(RobotSnapshot robot, ByteSink payload) {
        int hinges = robot.jointDegrees().length;
        DeltaTrack track = robotTracks.computeIfAbsent(
                robot.id(), id -> new DeltaTrack(RecordingFormat.NUMBERS_PER_POSE + hinges));
        track.putPose(0, robot.linkPoses(), 0, payload);
        for (int i = 0; i < hinges; i++) {
            track.put(
                    RecordingFormat.NUMBERS_PER_POSE + i,
                    robot.jointDegrees()[i],
                    RecordingFormat.STEPS_PER_DEGREE,
                    payload);
        }
    }
}
