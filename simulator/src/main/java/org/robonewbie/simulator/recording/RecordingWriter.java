package org.robonewbie.simulator.recording;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.model.Hinge;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.effector.EffectorCommand.SetHingeSpeed;
import org.robonewbie.simulator.physics.Pose;
import org.robonewbie.simulator.soccer.GameState;
import org.robonewbie.simulator.soccer.Match;
import org.robonewbie.simulator.soccer.Player;
import org.robonewbie.simulator.world.Ball;
import org.robonewbie.simulator.world.Robot;

/**
 * Writes a recording: each cycle's changes of game, ball, robots and commands. Equal runs give equal bytes.
 */
public final class RecordingWriter implements AutoCloseable {

    private static final int CYCLES_PER_FLUSH = 50;

    private final RecordingStream stream;
    private final RecordSink sink;
    private final DeltaTrack ballTrack = new DeltaTrack(RecordingFormat.NUMBERS_PER_POSE);
    private final Map<Integer, RobotTrack> robotTracks = new HashMap<>();
    private List<String> lastRobots = List.of();
    private double lastPlaySeconds;

    private RecordingWriter(RecordingStream stream) {
        this.stream = stream;
        this.sink = new RecordSink(stream);
    }

    /**
     * Begins a recording.
     *
     * @param file the file to write, or empty for the checksum only
     * @param header lines of the form {@code name=value} that describe the run
     * @param console takes sentences for people
     * @return the writer
     * @throws IOException if the file cannot be written; the message says what to do
     */
    public static RecordingWriter open(Optional<Path> file, List<String> header, Consumer<String> console)
            throws IOException {
        RecordingWriter writer = new RecordingWriter(RecordingStream.open(file, console));
        writer.sink.begin(header);
        return writer;
    }

    /**
     * Writes one cycle.
     *
     * @param cycle its number
     * @param match the game
     * @param ball the ball
     * @param participants all robots in the order in which they connected
     */
    public void write(long cycle, Match match, Ball ball, List<Participant> participants) {
        match.events().forEach(event -> sink.putEvent(event.text()));
        writeGame(match);
        writeRobots(participants);
        writeCommands(participants);
        writeCycle(cycle, match.state(), ball, participants);
        sink.send();
        if (cycle % CYCLES_PER_FLUSH == 0) {
            stream.flush();
        }
    }

    /**
     * Tells the checksum of the uncompressed recording so far.
     *
     * @return SHA-256 in 64 hexadecimal digits
     */
    public String sha256() {
        return stream.sha256();
    }

    @Override
    public void close() {
        stream.close();
    }

    /** What the last cycle knew of one robot. */
    private static final class RobotTrack {

        final DeltaTrack poses;
        final long[] speeds;

        RobotTrack(Robot robot) {
            int hinges = robot.model().hinges().size();
            poses = new DeltaTrack(RecordingFormat.NUMBERS_PER_POSE + hinges);
            speeds = new long[hinges];
        }
    }

    private void writeGame(Match match) {
        GameState state = match.state();
        sink.putGame(
                state.playMode(),
                state.half(),
                state.score(TeamSide.LEFT),
                state.score(TeamSide.RIGHT),
                match.teams().name(TeamSide.LEFT),
                match.teams().name(TeamSide.RIGHT));
    }

    private void writeRobots(List<Participant> participants) {
        List<String> robots =
                participants.stream().map(RecordingWriter::describe).toList();
        if (robots.equals(lastRobots)) {
            return;
        }
        lastRobots = robots;
        ByteSink payload = sink.newPayload();
        payload.putUnsigned(participants.size());
        for (Participant participant : participants) {
            payload.putUnsigned(participant.id());
            payload.putUnsigned(participant.robot().model().type().ordinal());
            payload.putUnsigned(participant
                            .player()
                            .map(Player::side)
                            .map(TeamSide::ordinal)
                            .orElse(-1)
                    + 1);
            payload.putUnsigned(participant.player().map(Player::number).orElse(0));
            payload.putText(
                    participant.player().map(player -> player.team().name()).orElse(""));
        }
        sink.put(RecordingFormat.ROBOTS);
    }

    private static String describe(Participant participant) {
        return participant.id() + " " + participant.robot().model().type() + " "
                + participant
                        .player()
                        .map(player -> player.side() + " " + player)
                        .orElse("");
    }

    private void writeCommands(List<Participant> participants) {
        for (Participant participant : participants) {
            if (!participant.commands().isEmpty()) {
                ByteSink payload = sink.newPayload();
                payload.putUnsigned(participant.id());
                if (putCommands(participant, payload)) {
                    sink.put(RecordingFormat.COMMANDS);
                }
            }
        }
    }

    /** Writes the hinge speeds that have changed and the other commands; tells whether there was anything to write. */
    private boolean putCommands(Participant participant, ByteSink payload) {
        RobotTrack track = track(participant);
        List<Hinge> hinges = participant.robot().model().hinges();
        List<String> others = new ArrayList<>(0);
        ByteSink speeds = new ByteSink();
        int changes = 0;
        for (EffectorCommand command : participant.commands()) {
            if (command instanceof SetHingeSpeed speed) {
                changes += putSpeed(track, hinges, speed, speeds);
            } else {
                others.add(command.toString());
            }
        }
        payload.putUnsigned(changes);
        payload.putBytes(speeds.bytes(), speeds.length());
        payload.putUnsigned(others.size());
        others.forEach(payload::putText);
        return changes > 0 || !others.isEmpty();
    }

    private static int putSpeed(RobotTrack track, List<Hinge> hinges, SetHingeSpeed command, ByteSink speeds) {
        for (int i = 0; i < hinges.size(); i++) {
            if (hinges.get(i).effectorName().equals(command.effectorName())) {
                long steps = Math.round(command.radiansPerSecond() * RecordingFormat.STEPS_PER_RADIAN);
                if (steps == track.speeds[i]) {
                    return 0;
                }
                speeds.putUnsigned(i);
                speeds.putSigned(steps);
                track.speeds[i] = steps;
                return 1;
            }
        }
        return 0;
    }

    private void writeCycle(long cycle, GameState state, Ball ball, List<Participant> participants) {
        ByteSink payload = sink.newPayload();
        payload.putUnsigned(cycle);
        payload.putSigned(Math.round((state.playSeconds() - lastPlaySeconds) * 50));
        lastPlaySeconds = state.playSeconds();
        ballTrack.putPose(0, new Pose(ball.position(), ball.rotation()), payload);
        for (Participant participant : participants) {
            Robot robot = participant.robot();
            DeltaTrack track = track(participant).poses;
            track.putPose(0, robot.torso(), payload);
            for (int i = 0; i < robot.model().hinges().size(); i++) {
                track.put(
                        RecordingFormat.NUMBERS_PER_POSE + i,
                        robot.jointDegrees(i),
                        RecordingFormat.STEPS_PER_DEGREE,
                        payload);
            }
        }
        sink.put(RecordingFormat.CYCLE);
    }

    private RobotTrack track(Participant participant) {
        return robotTracks.computeIfAbsent(participant.id(), id -> new RobotTrack(participant.robot()));
    }
}
