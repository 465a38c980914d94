package org.robonewbie.simulator.monitor;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.protocol.monitor.Foul;
import org.robonewbie.protocol.monitor.FoulType;
import org.robonewbie.protocol.monitor.MonitoredGame;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.file.RecordingFile;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.physics.RotationMatrix;
import org.robonewbie.simulator.recording.DamagedRecordingException;
import org.robonewbie.simulator.recording.RecordedCycle;
import org.robonewbie.simulator.recording.RecordingReader;
import org.robonewbie.simulator.soccer.SoccerParameter;
import org.robonewbie.simulator.soccer.SoccerParameters;

/** Converts a recording to a log for replay in RoboViz and rcssmonitor3d. */
public final class RecordedLog {

    private static final String FOUL = "foul ";
    private static final Pattern NUMBER = Pattern.compile("[0-9]{1,3}");

    private final List<Foul> fouls = new ArrayList<>();

    private RecordedLog() {}

    /**
     * Converts a recording to a log file.
     *
     * @param recording the recording
     * @param log the log file; an existing file is replaced
     * @throws DamagedRecordingException if the file is not a recording or is damaged
     * @throws IOException if a file cannot be read or written, or if the recording shows robots other than NAOs; the message says which
     */
    public static void write(Path recording, Path log) throws IOException {
        try (RecordingReader reader = RecordingFile.read(recording);
                MonitorLog lines = MonitorLog.open(log, parameters(reader.header()), problem -> {})) {
            write(reader, lines);
        }
    }

    /**
     * Converts a recording to a log.
     *
     * @param recording the recording, positioned before the first cycle
     * @param log receives the log; closed at the end
     * @throws DamagedRecordingException if the recording is damaged
     * @throws IOException if it cannot be read, or if it shows robots other than NAOs
     */
    public static void write(RecordingReader recording, OutputStream log) throws IOException {
        try (MonitorLog lines = new MonitorLog("", log, parameters(recording.header()), problem -> {})) {
            write(recording, lines);
        }
    }

    private static void write(RecordingReader reader, MonitorLog lines) throws IOException {
        RecordedLog converter = new RecordedLog();
        try {
            for (Optional<RecordedCycle> cycle = reader.next(); cycle.isPresent(); cycle = reader.next()) {
                WorldSnapshot state = cycle.get().snapshot();
                requireNaos(state);
                cycle.get().events().forEach(converter::noteFoul);
                lines.cycleEnded(state.cycle(), () -> converter.snapshot(state));
            }
        } catch (IllegalArgumentException invalid) {
            throw new DamagedRecordingException("The recording is damaged. " + invalid.getMessage(), invalid);
        }
    }

    private static void requireNaos(WorldSnapshot state) throws IOException {
        for (RobotSnapshot robot : state.robots()) {
            if (robot.nao().isEmpty()) {
                throw new IOException("The recording shows a "
                        + robot.state().model().name()
                        + ", but a SimSpark log contains only NAOs. Export a page or a video instead.");
            }
        }
    }

    private static SoccerParameters parameters(Map<String, String> header) {
        SoccerParameters parameters = SoccerParameters.league();
        for (SoccerParameter parameter : SoccerParameter.values()) {
            String value = header.get(parameter.simSparkName());
            if (value != null) {
                parameters = parameters.with(parameter.simSparkName() + "=" + value);
            }
        }
        return parameters;
    }

    /** Parses an event written by {@code MatchEvent.FoulCalled}. */
    private void noteFoul(String event) {
        String[] words = event.split(" ", -1);
        if (!event.startsWith(FOUL)
                || words.length != 4
                || !NUMBER.matcher(words[3]).matches()) {
            return;
        }
        TeamSide side = words[2].equals("left") ? TeamSide.LEFT : TeamSide.RIGHT;
        for (FoulType type : FoulType.values()) {
            if (type.name().equals(words[1])) {
                fouls.add(new Foul(fouls.size() + 1, type, new PlayerNumber(side, Integer.parseInt(words[3]))));
            }
        }
    }

    private MonitorSnapshot snapshot(WorldSnapshot state) {
        BodyPose ball = new BodyPose(state.ballPosition(), RotationMatrix.of(state.ballRotation()));
        MonitoredGame game = new MonitoredGame(
                state.gameTime(),
                Optional.of(state.teamLeft()).filter(name -> !name.isEmpty()),
                Optional.of(state.teamRight()).filter(name -> !name.isEmpty()),
                state.half(),
                state.scoreLeft(),
                state.scoreRight(),
                Optional.of(state.playMode()),
                0,
                0);
        return new MonitorSnapshot(
                game,
                List.copyOf(fouls),
                MonitoredRobotState.transform(ball),
                state.things(),
                state.robots().stream().map(RecordedLog::robot).toList());
    }

    private static MonitoredRobotState robot(RobotSnapshot robot) {
        List<BodyPose> links =
                robot.body().limbs().links().stream().map(BodyPose::ofBodyAxes).toList();
        Optional<PlayerNumber> player =
                robot.side().filter(side -> robot.number() > 0).map(side -> new PlayerNumber(side, robot.number()));
        return MonitoredRobotState.of(robot.id(), robot.type(), links, player, false);
    }
}
