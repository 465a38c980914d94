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
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.SimSparkFrame;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.robot.RobotModel;
import org.robonewbie.robot.RobotState;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.json.RobotModelJson;
import org.robonewbie.simulator.landscape.Thing;

/**
 * A reader that returns a recording cycle by cycle. It can also read the unfinished file of a program that was killed.
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

    private final DataInputStream in;
    private final DeltaTrack ballTrack = new DeltaTrack(RecordingFormat.NUMBERS_PER_POSE);
    private final Map<Integer, DeltaTrack> robotTracks = new HashMap<>();
    private Map<String, String> header = Map.of();
    private final List<RobotModel> models = new ArrayList<>();
    private List<ListedRobot> robots = List.of();
    private List<Thing> things = List.of();
    private Game game = new Game(PlayMode.BEFORE_KICK_OFF, 1, 0, 0, "", "");
    private long playTicks;

    private record Game(PlayMode playMode, int half, int scoreLeft, int scoreRight, String left, String right) {}

    private RecordingReader(InputStream stream) {
        this.in = new DataInputStream(stream);
    }

    /**
     * Opens a recording.
     *
     * @param raw the bytes of the recording; closed with the reader
     * @param name name of the recording in messages, such as a file name in quotes
     * @return the reader, positioned before the first cycle
     * @throws DamagedRecordingException if the data is not a recording
     * @throws IOException if it cannot be read
     */
    public static RecordingReader of(InputStream raw, String name) throws IOException {
        try {
            return ofUnpacked(new BufferedInputStream(new GZIPInputStream(raw)), name);
        } catch (ZipException | EOFException e) {
            throw damaged(name, e);
        }
    }

    private static DamagedRecordingException damaged(String name, Exception reason) {
        return new DamagedRecordingException(name + " is not a RoboNewbie recording, or it is damaged.", reason);
    }

    /**
     * Opens an uncompressed recording, as received by a {@link RecordingTarget}.
     *
     * @param raw the bytes; closed with the reader
     * @param name name of the recording in messages
     * @return the reader, positioned before the first cycle
     * @throws DamagedRecordingException if the data is not a recording
     * @throws IOException if it cannot be read
     */
    public static RecordingReader ofUnpacked(InputStream raw, String name) throws IOException {
        try {
            RecordingReader reader = new RecordingReader(raw);
            reader.readHeader(name);
            return reader;
        } catch (ZipException | EOFException | IndexOutOfBoundsException e) {
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
     * @return the cycle; empty at the end of the recording, even if it ends in the middle of a cycle
     * @throws DamagedRecordingException if the file is damaged
     * @throws IOException if it cannot be read
     */
    public Optional<RecordedCycle> next() throws IOException {
        List<RobotCommands> commands = new ArrayList<>();
        List<String> events = new ArrayList<>();
        try {
            while (true) {
                int kind = in.readUnsignedByte();
                RecordCursor content = readPayload();
                switch (kind) {
                    case RecordingFormat.GAME -> game = readGame(content);
                    case RecordingFormat.MODEL -> readModel(content);
                    case RecordingFormat.ROBOTS -> robots = ListedRobot.readAll(content, types());
                    case RecordingFormat.COMMANDS -> commands.add(readCommands(content));
                    case RecordingFormat.EVENT -> events.add(content.getText());
                    case RecordingFormat.THINGS -> things = List.copyOf(ThingTrack.readAll(content));
                    case RecordingFormat.MOVED_THING -> things = ThingTrack.readMoved(things, content);
                    case RecordingFormat.CYCLE -> {
                        return Optional.of(new RecordedCycle(readCycle(content), commands, events));
                    }
                    default -> {}
                }
            }
        } catch (EOFException | ZipException e) {
            return Optional.empty();
        } catch (IndexOutOfBoundsException invalid) {
            throw new DamagedRecordingException(
                    "The recording contains an invalid record. The file is damaged.", invalid);
        }
    }

    @Override
    public void close() throws IOException {
        in.close();
    }

    private void readHeader(String name) throws IOException {
        byte[] magic = in.readNBytes(RecordingFormat.MAGIC.length());
        if (!new String(magic, StandardCharsets.US_ASCII).equals(RecordingFormat.MAGIC)) {
            throw new DamagedRecordingException(name + " is not a RoboNewbie recording, or it is damaged.");
        }
        long version = readUnsigned();
        if (version != RecordingFormat.VERSION) {
            throw new DamagedRecordingException(
                    "Recording " + name + " has version " + version + ", but this program reads only version "
                            + RecordingFormat.VERSION + ". Use the program that created it.");
        }
        in.readUnsignedByte();
        header = RecordingFormat.readHeader(readPayload());
    }

    private RecordCursor readPayload() throws IOException {
        long length = readUnsigned();
        if (length < 0 || length > RecordingFormat.MAX_RECORD_BYTES) {
            throw new DamagedRecordingException(
                    "A record of " + length + " bytes is too long for a recording. The file is damaged.");
        }
        byte[] bytes = in.readNBytes((int) length);
        if (bytes.length < length) {
            throw new EOFException();
        }
        return new RecordCursor(bytes, 0, bytes.length);
    }

    private long readUnsigned() throws IOException {
        long value = 0;
        int shift = 0;
        int next;
        do {
            next = in.readUnsignedByte();
            value |= (long) (next & 0x7F) << shift;
            shift += 7;
        } while (next > 0x7F && shift < Long.SIZE);
        return value;
    }

    private static Game readGame(RecordCursor content) {
        PlayMode playMode = PlayMode.ofName(content.getText()).orElse(PlayMode.PLAY_ON);
        int half = (int) content.getUnsigned();
        int scoreLeft = (int) content.getUnsigned();
        int scoreRight = (int) content.getUnsigned();
        return new Game(playMode, half, scoreLeft, scoreRight, content.getText(), content.getText());
    }

    private static RobotCommands readCommands(RecordCursor content) {
        int id = (int) content.getUnsigned();
        List<RobotCommands.HingeSpeed> speeds = new ArrayList<>();
        for (long count = content.getUnsigned(); count > 0; count--) {
            int hinge = (int) content.getUnsigned();
            speeds.add(new RobotCommands.HingeSpeed(hinge, content.getSigned() / RecordingFormat.STEPS_PER_RADIAN));
        }
        List<String> others = new ArrayList<>();
        for (long count = content.getUnsigned(); count > 0; count--) {
            others.add(content.getText());
        }
        return new RobotCommands(id, speeds, others);
    }

    private WorldSnapshot readCycle(RecordCursor content) {
        long cycle = content.getUnsigned();
        playTicks += content.getSigned();
        Pose ball = ballTrack.getPose(content);
        List<RobotSnapshot> snapshots = new ArrayList<>();
        for (ListedRobot robot : robots) {
            snapshots.add(readRobot(robot, content));
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

    private RobotSnapshot readRobot(ListedRobot robot, RecordCursor content) {
        int hinges = hinges(robot.type());
        DeltaTrack track = robotTracks.compute(
                robot.id(), (id, known) -> DeltaTrack.fitting(known, RecordingFormat.NUMBERS_PER_POSE + hinges));
        Pose torso = track.getPose(content);
        double[] degrees = new double[hinges];
        for (int i = 0; i < hinges; i++) {
            degrees[i] = track.get(RecordingFormat.NUMBERS_PER_POSE + i, RecordingFormat.STEPS_PER_DEGREE, content);
        }
        return new RobotSnapshot(
                robot.id(),
                robot.team(),
                robot.teamSide(),
                robot.number(),
                state(robot.type(), SimSparkFrame.linkToBody(torso), degrees));
    }

    private RobotState state(int type, Pose torso, double[] degrees) {
        return type < RecordingFormat.NAO_TYPES
                ? new RobotState.OfNao(BodyState.ofHinges(RobotType.values()[type], torso, degrees))
                : new RobotState.OfModel(models.get(type - RecordingFormat.NAO_TYPES), torso, degrees);
    }

    private int hinges(int type) {
        return type < RecordingFormat.NAO_TYPES
                ? NaoModel.of(RobotType.values()[type]).hinges().size()
                : models.get(type - RecordingFormat.NAO_TYPES).joints().size();
    }

    private int types() {
        return RecordingFormat.NAO_TYPES + models.size();
    }

    private void readModel(RecordCursor content) throws DamagedRecordingException {
        long type = content.getUnsigned();
        long joints = content.getUnsigned();
        RobotModel model;
        try {
            model = RobotModelJson.read(content.getText());
        } catch (IllegalArgumentException unreadable) {
            throw new DamagedRecordingException(
                    "The recording defines a robot that cannot be read: " + unreadable.getMessage(), unreadable);
        }
        if (type != types() || joints != model.joints().size()) {
            throw new DamagedRecordingException("The recording defines robot type " + type + " with " + joints
                    + " joints, but type " + types() + " comes next and has "
                    + model.joints().size() + ". The file is damaged.");
        }
        models.add(model);
    }
}
