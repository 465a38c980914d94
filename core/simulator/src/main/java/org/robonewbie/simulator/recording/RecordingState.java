package org.robonewbie.simulator.recording;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.json.RobotModelJson;

/**
 * An incremental reader of a recording. It keeps the state after the last cycle as raw fixed-point values, so that
 * another reader can start from there. It accepts the bytes in chunks and reports events and cycles to a listener.
 *
 * <pre>{@code
 * RecordingState state = new RecordingState(listener);
 * state.push(bytes, count);
 * byte[] start = state.toRecords(); // a prefix for the records that follow
 * }</pre>
 *
 * <p>The format is described in {@code docs/recording-format.md}.
 */
public final class RecordingState {

    /** Number of values of a pose: x, y, z, and a quaternion w, x, y, z. */
    public static final int NUMBERS_PER_POSE = RecordingFormat.NUMBERS_PER_POSE;

    /** Resolution of positions in steps per metre. */
    public static final double STEPS_PER_METRE = RecordingFormat.STEPS_PER_METRE;

    private static final int MAX_HINGES = 24;

    private final Listener listener;
    private Map<String, String> header = Map.of();
    private final long[] ball = new long[NUMBERS_PER_POSE];
    private final Map<Integer, long[]> tracks = new LinkedHashMap<>();
    private final Map<Integer, long[]> speeds = new LinkedHashMap<>();
    private final List<ListedModel> models = new ArrayList<>();
    private List<ListedRobot> robots = List.of();
    private byte[] game = {};
    private List<Integer> score = List.of(0, 0);
    private List<String> teams = List.of("", "");
    private byte[] roster = {};
    private byte[] things = {};
    private final Map<Long, byte[]> movedThings = new LinkedHashMap<>();
    private long playTicks;
    private byte[] rest = {};
    private boolean begun;
    private boolean betweenCycles = true;

    /** A record of kind {@link RecordingFormat#MODEL}; never compared. */
    @SuppressWarnings("ArrayRecordComponent")
    private record ListedModel(int joints, String json, byte[] payload) {}

    /** A listener for the contents of a recording. */
    public interface Listener {

        /**
         * Called for an event of the current cycle, before {@link #cycleEnded}.
         *
         * @param text the event, such as {@code goal left Stars}
         */
        void happened(String text);

        /**
         * Called at the end of a cycle.
         *
         * @param cycle number of the cycle since the start of the simulation
         * @param state the state after the cycle
         */
        void cycleEnded(long cycle, RecordingState state);
    }

    /**
     * Creates the initial state, before any bytes have been read.
     *
     * @param listener receives events and cycles
     */
    public RecordingState(Listener listener) {
        this.listener = listener;
    }

    /**
     * Parses the next chunk of the uncompressed recording.
     *
     * @param bytes array that starts with the chunk
     * @param count length of the chunk in bytes
     * @throws IllegalArgumentException if the data is damaged or is not a recording of this version
     */
    public void push(byte[] bytes, int count) {
        byte[] all = Arrays.copyOf(rest, rest.length + count);
        System.arraycopy(bytes, 0, all, rest.length, count);
        RecordCursor cursor = new RecordCursor(all, 0, all.length);
        int end = 0;
        while (takesNext(cursor, all)) {
            end = cursor.position();
        }
        betweenCycles &= end == all.length;
        rest = Arrays.copyOfRange(all, end, all.length);
    }

    /** Reads the next record; returns false if it is incomplete. */
    private boolean takesNext(RecordCursor cursor, byte[] all) {
        if (cursor.isAtEnd()) {
            return false;
        }
        int kind;
        int from;
        try {
            if (!begun) {
                begin(cursor, all);
                return true;
            }
            kind = cursor.getByte();
            long length = cursor.getUnsigned();
            if (length < 0 || length > RecordingFormat.MAX_RECORD_BYTES) {
                throw damaged();
            }
            from = cursor.skip(length);
        } catch (IndexOutOfBoundsException incomplete) {
            return false;
        }
        try {
            take(kind, all, from, cursor.position());
        } catch (IndexOutOfBoundsException invalid) {
            throw damaged();
        }
        return true;
    }

    private static IllegalArgumentException damaged() {
        return new IllegalArgumentException("The recording is damaged from here on.");
    }

    private void begin(RecordCursor cursor, byte[] all) {
        int from = cursor.skip(RecordingFormat.MAGIC.length());
        String magic = new String(all, from, RecordingFormat.MAGIC.length(), StandardCharsets.US_ASCII);
        long version = cursor.getUnsigned();
        if (!magic.equals(RecordingFormat.MAGIC) || version != RecordingFormat.VERSION) {
            throw new IllegalArgumentException("This is not a recording of version " + RecordingFormat.VERSION
                    + ". Use the program that created it.");
        }
        begun = true;
    }

    private void take(int kind, byte[] bytes, int from, int end) {
        RecordCursor content = new RecordCursor(bytes, from, end);
        betweenCycles = kind == RecordingFormat.CYCLE;
        switch (kind) {
            case RecordingFormat.HEADER -> header = RecordingFormat.readHeader(content);
            case RecordingFormat.GAME -> takeGame(Arrays.copyOfRange(bytes, from, end), content);
            case RecordingFormat.MODEL -> takeModel(Arrays.copyOfRange(bytes, from, end), content);
            case RecordingFormat.ROBOTS -> takeRobots(Arrays.copyOfRange(bytes, from, end), content);
            case RecordingFormat.COMMANDS -> takeCommands(content);
            case RecordingFormat.EVENT -> listener.happened(content.getText());
            case RecordingFormat.CYCLE -> takeCycle(content);
            case RecordingFormat.STATE -> takeState(content);
            case RecordingFormat.THINGS -> takeThings(Arrays.copyOfRange(bytes, from, end));
            case RecordingFormat.MOVED_THING ->
                movedThings.put(content.getUnsigned(), Arrays.copyOfRange(bytes, from, end));
            default -> {}
        }
    }

    private void takeGame(byte[] payload, RecordCursor content) {
        content.getText(); // play mode
        content.getUnsigned(); // half
        List<Integer> goals = List.of((int) content.getUnsigned(), (int) content.getUnsigned());
        teams = List.of(content.getText(), content.getText());
        score = goals;
        game = payload;
    }

    private void takeRobots(byte[] payload, RecordCursor content) {
        robots = ListedRobot.readAll(content, RecordingFormat.NAO_TYPES + models.size());
        roster = payload;
    }

    private void takeModel(byte[] payload, RecordCursor content) {
        int type = (int) content.getUnsigned();
        int joints = content.getCount();
        String json = content.getText();
        if (type != RecordingFormat.NAO_TYPES + models.size() || joints != jointsOf(json)) {
            throw damaged();
        }
        models.add(new ListedModel(joints, json, payload));
    }

    /** Returns the number of joints of a model, or -1 if it cannot be read. */
    private static int jointsOf(String json) {
        try {
            return RobotModelJson.read(json).joints().size();
        } catch (IllegalArgumentException unreadable) {
            return -1;
        }
    }

    private void takeThings(byte[] payload) {
        things = payload;
        movedThings.clear();
    }

    private void takeCommands(RecordCursor content) {
        long[] known = speeds.computeIfAbsent((int) content.getUnsigned(), id -> new long[MAX_HINGES]);
        for (long count = content.getUnsigned(); count > 0; count--) {
            int hinge = content.getIndex(MAX_HINGES);
            known[hinge] = content.getSigned();
        }
    }

    private void takeCycle(RecordCursor content) {
        long cycle = content.getUnsigned();
        playTicks += content.getSigned();
        takeTrack(ball, content);
        for (ListedRobot robot : robots) {
            int numbers = numbersOf(robot);
            takeTrack(
                    tracks.compute(
                            robot.id(),
                            (id, known) -> known != null && known.length == numbers ? known : new long[numbers]),
                    content);
        }
        listener.cycleEnded(cycle, this);
    }

    private void takeState(RecordCursor content) {
        playTicks = content.getSigned();
        Arrays.fill(ball, 0);
        takeTrack(ball, content);
        tracks.clear();
        while (!content.isAtEnd()) {
            int id = (int) content.getUnsigned();
            long[] track = new long[content.getCount()];
            takeTrack(track, content);
            tracks.put(id, track);
        }
    }

    private int numbersOf(ListedRobot robot) {
        int hinges = robot.type() < RecordingFormat.NAO_TYPES
                ? NaoModel.of(RobotType.values()[robot.type()]).hinges().size()
                : models.get(robot.type() - RecordingFormat.NAO_TYPES).joints();
        return NUMBERS_PER_POSE + hinges;
    }

    private static void takeTrack(long[] track, RecordCursor content) {
        for (int i = 0; i < track.length; i++) {
            track[i] += content.getSigned();
        }
    }

    /** {@return whether the last byte read ends a cycle, so that another reader can start after it} */
    public boolean isBetweenCycles() {
        return begun && betweenCycles && rest.length == 0;
    }

    /** {@return the values of the header by name} */
    public Map<String, String> header() {
        return Map.copyOf(header);
    }

    /** {@return the robots of the last cycle} */
    public List<ListedRobot> robots() {
        return robots;
    }

    /** {@return the models that the recording defines so far, in JSON, by the name of their type} */
    public Map<String, String> models() {
        Map<String, String> known = new LinkedHashMap<>();
        models.forEach(model -> known.put("TYPE_" + (RecordingFormat.NAO_TYPES + known.size()), model.json()));
        return known;
    }

    /**
     * Returns a component of a robot's pose.
     *
     * @param robot the robot
     * @param index 0 to 2 for x, y, z in steps of 0.1 mm, 3 to 6 for the quaternion
     * @return the raw value
     */
    public long number(ListedRobot robot, int index) {
        long[] track = tracks.get(robot.id());
        return track == null ? 0 : track[index];
    }

    /**
     * Returns a coordinate of the ball.
     *
     * @param index 0 to 2 for x, y, z
     * @return steps of 0.1 mm
     */
    public long ball(int index) {
        return ball[index];
    }

    /** {@return the goals of the left and right teams} */
    public List<Integer> score() {
        return score;
    }

    /** {@return the names of the left and right teams; empty for a missing team} */
    public List<String> teams() {
        return teams;
    }

    /** {@return records that restore this state in a reader; they contain a record of kind 7, which never occurs in a file} */
    public byte[] toRecords() {
        ByteSink records = new ByteSink();
        put(RecordingFormat.GAME, game, records);
        models.forEach(model -> put(RecordingFormat.MODEL, model.payload(), records));
        put(RecordingFormat.ROBOTS, roster, records);
        put(RecordingFormat.THINGS, things, records);
        movedThings.values().forEach(moved -> put(RecordingFormat.MOVED_THING, moved, records));
        speeds.forEach((id, known) -> {
            ByteSink payload = new ByteSink();
            payload.putUnsigned(id);
            payload.putUnsigned(known.length);
            for (int i = 0; i < known.length; i++) {
                payload.putUnsigned(i);
                payload.putSigned(known[i]);
            }
            payload.putUnsigned(0);
            put(RecordingFormat.COMMANDS, Arrays.copyOf(payload.bytes(), payload.length()), records);
        });
        put(RecordingFormat.STATE, tracksAsBytes(), records);
        return Arrays.copyOf(records.bytes(), records.length());
    }

    private byte[] tracksAsBytes() {
        ByteSink payload = new ByteSink();
        payload.putSigned(playTicks);
        putTrack(ball, payload);
        tracks.forEach((id, track) -> {
            payload.putUnsigned(id);
            payload.putUnsigned(track.length);
            putTrack(track, payload);
        });
        return Arrays.copyOf(payload.bytes(), payload.length());
    }

    private static void putTrack(long[] track, ByteSink payload) {
        for (long number : track) {
            payload.putSigned(number);
        }
    }

    private static void put(int kind, byte[] payload, ByteSink records) {
        if (payload.length > 0) {
            records.putByte(kind);
            records.putUnsigned(payload.length);
            records.putBytes(payload, payload.length);
        }
    }
}
