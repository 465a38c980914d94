package org.robonewbie.simulator.recording;

import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.zip.GZIPInputStream;
import java.util.zip.ZipException;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.SimSparkFrame;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.landscape.Thing;

/**
 * Reads a recording cycle by cycle, also the part that a killed program has left.
 *
 * <pre>{@code
 * try (RecordingReader reader = RecordingFile.read(file)) {
 *     for (Optional<RecordedCycle> cycle = reader.next(); cycle.isPresent(); cycle = reader.next()) {
 *         show(cycle.get().snapshot());
 *     }
 * }
 * }</pre>
 */
public final class RecordingReader implements AutoCloseable {

    private final InputStream stream;
    private final ByteSource source;
    private final Map<String, String> header = new HashMap<>();
    private final DeltaTrack ballTrack = new DeltaTrack(RecordingFormat.NUMBERS_PER_POSE);
    private final Map<Integer, DeltaTrack> robotTracks = new HashMap<>();
    private List<RecordedRobot> robots = List.of();
    private List<Thing> things = List.of();
    private Game game = new Game(PlayMode.BEFORE_KICK_OFF, 1, 0, 0, "", "");
    private long playTicks;

    private record Game(PlayMode playMode, int half, int scoreLeft, int scoreRight, String left, String right) {}

    private record RecordedRobot(int id, RobotType type, Optional<TeamSide> side, int number, String team) {}

    private RecordingReader(InputStream stream) {
        this.stream = stream;
        this.source = new ByteSource(new DataInputStream(stream));
    }

    /**
     * Begins to read a recording.
     *
     * @param raw the bytes of a recording; closed with the reader
     * @param name how to call it in messages, such as its file's name in quotes
     * @return the reader, before the first cycle
     * @throws DamagedRecordingException if it is no recording; the message says so
     * @throws IOException if it cannot be read
     */
    public static RecordingReader of(InputStream raw, String name) throws IOException {
        try {
            return ofUnpacked(new BufferedInputStream(new GZIPInputStream(raw)), name);
        } catch (ZipException | EOFException e) {
            throw damaged(name, e);
        }
    }

    private static DamagedRecordingException damaged(String name, IOException reason) {
        return new DamagedRecordingException(name + " is not a recording of RoboNewbie, or it is damaged.", reason);
    }

    /**
     * Begins to read a recording that is not compressed, as a {@link RecordingTarget} gets it.
     *
     * @param raw the bytes; closed with the reader
     * @param name how to call it in messages
     * @return the reader, before the first cycle
     * @throws DamagedRecordingException if it is no recording; the message says so
     * @throws IOException if it cannot be read
     */
    public static RecordingReader ofUnpacked(InputStream raw, String name) throws IOException {
        try {
            RecordingReader reader = new RecordingReader(raw);
            reader.readBeginning(name);
            return reader;
        } catch (ZipException | EOFException e) {
            throw damaged(name, e);
        }
    }

    /** {@return the values of the header by name, such as {@code seed} or {@code FieldLength}} */
    public Map<String, String> header() {
        return Map.copyOf(header);
    }

    /**
     * Reads the next cycle.
     *
     * @return the cycle, or empty at the end of the recording, also if it ends in the middle of a cycle
     * @throws DamagedRecordingException if the file is damaged
     * @throws IOException if it cannot be read
     */
    public Optional<RecordedCycle> next() throws IOException {
        List<RobotCommands> commands = new ArrayList<>();
        List<String> events = new ArrayList<>();
        try {
            while (true) {
                int kind = source.getByte();
                long length = source.getUnsigned();
                switch (kind) {
                    case RecordingFormat.GAME -> game = readGame();
                    case RecordingFormat.ROBOTS -> robots = readRobots();
                    case RecordingFormat.COMMANDS -> commands.add(readCommands());
                    case RecordingFormat.EVENT -> events.add(source.getText());
                    case RecordingFormat.THINGS -> things = List.copyOf(ThingTrack.readAll(source));
                    case RecordingFormat.MOVED_THING -> things = ThingTrack.readMoved(things, source);
                    case RecordingFormat.CYCLE -> {
                        return Optional.of(new RecordedCycle(readCycle(), commands, events));
                    }
                    default -> source.getBytes(length);
                }
            }
        } catch (EOFException | ZipException e) {
            return Optional.empty();
        }
    }

    @Override
    public void close() throws IOException {
        stream.close();
    }

    private void readBeginning(String name) throws IOException {
        byte[] magic = source.getBytes(RecordingFormat.MAGIC.length());
        if (!new String(magic, StandardCharsets.US_ASCII).equals(RecordingFormat.MAGIC)) {
            throw new DamagedRecordingException(name + " is not a recording of RoboNewbie, or it is damaged.");
        }
        long version = source.getUnsigned();
        if (version != RecordingFormat.VERSION) {
            throw new DamagedRecordingException(
                    "Recording " + name + " has version " + version + ", but this program reads version "
                            + RecordingFormat.VERSION + ". Use the program that made it.");
        }
        source.getByte();
        source.getUnsigned();
        for (String line : source.getText().split("\n", -1)) {
            readHeaderLine(line);
        }
    }

    private void readHeaderLine(String line) {
        int equals = line.indexOf('=');
        if (equals > 0) {
            header.put(line.substring(0, equals), line.substring(equals + 1));
        }
    }

    private Game readGame() throws IOException {
        PlayMode playMode = PlayMode.ofSimSparkName(source.getText()).orElse(PlayMode.PLAY_ON);
        int half = (int) source.getUnsigned();
        int scoreLeft = (int) source.getUnsigned();
        int scoreRight = (int) source.getUnsigned();
        return new Game(playMode, half, scoreLeft, scoreRight, source.getText(), source.getText());
    }

    private List<RecordedRobot> readRobots() throws IOException {
        List<RecordedRobot> read = new ArrayList<>();
        long count = source.getUnsigned();
        for (long i = 0; i < count; i++) {
            int id = (int) source.getUnsigned();
            RobotType type = chosen(RobotType.values(), source.getUnsigned());
            long side = source.getUnsigned();
            Optional<TeamSide> teamSide =
                    side == 0 ? Optional.empty() : Optional.of(chosen(TeamSide.values(), side - 1));
            read.add(new RecordedRobot(id, type, teamSide, (int) source.getUnsigned(), source.getText()));
        }
        return read;
    }

    private static <E extends Enum<E>> E chosen(E[] values, long index) throws IOException {
        if (index < 0 || index >= values.length) {
            throw new DamagedRecordingException("The recording names "
                    + values.getClass().getComponentType().getSimpleName() + " " + index + ", and the last one is "
                    + (values.length - 1) + ". The file is damaged.");
        }
        return values[(int) index];
    }

    private RobotCommands readCommands() throws IOException {
        int id = (int) source.getUnsigned();
        List<RobotCommands.HingeSpeed> speeds = new ArrayList<>();
        long count = source.getUnsigned();
        for (long i = 0; i < count; i++) {
            int hinge = (int) source.getUnsigned();
            speeds.add(new RobotCommands.HingeSpeed(hinge, source.getSigned() / RecordingFormat.STEPS_PER_RADIAN));
        }
        List<String> others = new ArrayList<>();
        long otherCount = source.getUnsigned();
        for (long i = 0; i < otherCount; i++) {
            others.add(source.getText());
        }
        return new RobotCommands(id, speeds, others);
    }

    private WorldSnapshot readCycle() throws IOException {
        long cycle = source.getUnsigned();
        playTicks += source.getSigned();
        Pose ball = ballTrack.getPose(source);
        List<RobotSnapshot> snapshots = new ArrayList<>();
        for (RecordedRobot robot : robots) {
            snapshots.add(readRobot(robot));
        }
        return new WorldSnapshot(
                cycle,
                playTicks * Cycle.SECONDS,
                game.playMode(),
                game.left(),
                game.right(),
                game.scoreLeft(),
                game.scoreRight(),
                game.half(),
                ball.position(),
                ball.rotation(),
                snapshots,
                things,
                false,
                1,
                1);
    }

    private RobotSnapshot readRobot(RecordedRobot robot) throws IOException {
        int hinges = NaoModel.of(robot.type()).hinges().size();
        DeltaTrack track = robotTracks.compute(
                robot.id(), (id, known) -> DeltaTrack.fitting(known, RecordingFormat.NUMBERS_PER_POSE + hinges));
        Pose torso = track.getPose(source);
        double[] degrees = new double[hinges];
        for (int i = 0; i < hinges; i++) {
            degrees[i] = track.get(RecordingFormat.NUMBERS_PER_POSE + i, RecordingFormat.STEPS_PER_DEGREE, source);
        }
        return new RobotSnapshot(
                robot.id(),
                robot.team(),
                robot.side(),
                robot.number(),
                BodyState.ofHinges(robot.type(), SimSparkFrame.linkToBody(torso), degrees));
    }
}
