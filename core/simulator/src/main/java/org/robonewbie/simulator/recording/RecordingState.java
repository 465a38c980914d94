package org.robonewbie.simulator.recording;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;

/**
 * What a recording has said up to some cycle, in its own numbers, so that one can begin to read in the middle of it. It is fed
 * with the bytes of a recording as they come, and tells a listener what it meets.
 *
 * <pre>{@code
 * RecordingState state = new RecordingState(listener);
 * state.push(bytes, count);
 * byte[] start = state.toRecords(); // these, and the records that follow, are read as the whole recording would be
 * }</pre>
 *
 * <p>The format is described in {@code docs/recording-format.md}.
 */
public final class RecordingState {

    /** How many numbers a pose has: x, y, z, and a quaternion w, x, y, z. */
    public static final int NUMBERS_PER_POSE = RecordingFormat.NUMBERS_PER_POSE;

    /** In how many steps a metre is kept. */
    public static final double STEPS_PER_METRE = RecordingFormat.STEPS_PER_METRE;

    private static final int MAX_HINGES = 24;
    private static final int MAX_RECORD_BYTES = 1 << 24;

    private final Listener listener;
    private final Map<String, String> header = new LinkedHashMap<>();
    private final long[] ball = new long[NUMBERS_PER_POSE];
    private final Map<Integer, long[]> tracks = new LinkedHashMap<>();
    private final Map<Integer, long[]> speeds = new LinkedHashMap<>();
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

    /** Listens to what a recording says. */
    public interface Listener {

        /**
         * Something happened, in the cycle that ends next.
         *
         * @param text such as {@code goal left Stars}
         */
        void happened(String text);

        /**
         * A cycle has ended.
         *
         * @param cycle number of the cycle since the start of the simulation
         * @param state all that is known now
         */
        void cycleEnded(long cycle, RecordingState state);
    }

    /**
     * Creates the state before the first byte.
     *
     * @param listener hears what the recording says
     */
    public RecordingState(Listener listener) {
        this.listener = listener;
    }

    /**
     * Takes the next bytes of the recording, already unpacked.
     *
     * @param bytes an array that begins with them
     * @param count how many there are
     * @throws IllegalArgumentException if they are no recording of this version, or a damaged one
     */
    public void push(byte[] bytes, int count) {
        byte[] all = Arrays.copyOf(rest, rest.length + count);
        System.arraycopy(bytes, 0, all, rest.length, count);
        RecordCursor cursor = new RecordCursor(all, 0, all.length);
        int good = 0;
        while (takesNext(cursor, all)) {
            good = cursor.position();
        }
        betweenCycles &= good == all.length;
        rest = Arrays.copyOfRange(all, good, all.length);
    }

    /** Takes the next record, and returns whether it was there as a whole. */
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
            if (length < 0 || length > MAX_RECORD_BYTES) {
                throw damaged();
            }
            from = cursor.skip(length);
        } catch (IndexOutOfBoundsException notYetThere) {
            return false;
        }
        try {
            take(kind, all, from, cursor.position());
        } catch (IndexOutOfBoundsException wrongNumber) {
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
            throw new IllegalArgumentException("These bytes are no recording of version " + RecordingFormat.VERSION
                    + ". Use the program that made it.");
        }
        begun = true;
    }

    private void take(int kind, byte[] bytes, int from, int end) {
        RecordCursor content = new RecordCursor(bytes, from, end);
        betweenCycles = kind == RecordingFormat.CYCLE;
        switch (kind) {
            case RecordingFormat.HEADER -> content.getText().lines().forEach(this::takeHeaderLine);
            case RecordingFormat.GAME -> takeGame(Arrays.copyOfRange(bytes, from, end), content);
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

    private void takeHeaderLine(String line) {
        int equals = line.indexOf('=');
        if (equals > 0) {
            header.put(line.substring(0, equals), line.substring(equals + 1));
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
        List<ListedRobot> read = new ArrayList<>();
        for (long count = content.getUnsigned(); count > 0; count--) {
            int id = (int) content.getUnsigned();
            RobotType type = RobotType.values()[(int) content.getUnsigned()];
            int side = (int) content.getUnsigned();
            read.add(new ListedRobot(id, type, side, (int) content.getUnsigned(), content.getText()));
        }
        robots = List.copyOf(read);
        roster = payload;
    }

    private void takeThings(byte[] payload) {
        things = payload;
        movedThings.clear();
    }

    private void takeCommands(RecordCursor content) {
        long[] known = speeds.computeIfAbsent((int) content.getUnsigned(), id -> new long[MAX_HINGES]);
        for (long count = content.getUnsigned(); count > 0; count--) {
            int hinge = (int) content.getUnsigned();
            known[hinge] = content.getSigned();
        }
    }

    private void takeCycle(RecordCursor content) {
        long cycle = content.getUnsigned();
        playTicks += content.getSigned();
        takeTrack(ball, content);
        for (ListedRobot robot : robots) {
            takeTrack(tracks.computeIfAbsent(robot.id(), id -> new long[numbersOf(robot)]), content);
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

    private static int numbersOf(ListedRobot robot) {
        return NUMBERS_PER_POSE + NaoModel.of(robot.type()).hinges().size();
    }

    private static void takeTrack(long[] track, RecordCursor content) {
        for (int i = 0; i < track.length; i++) {
            track[i] += content.getSigned();
        }
    }

    /** {@return whether the last byte so far was the last one of a cycle, so that one can begin to read behind it} */
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

    /**
     * Returns where a robot is along an axis, or a part of its rotation.
     *
     * @param robot the robot
     * @param index 0 to 2 for x, y, z in steps of 0.1 mm, 3 to 6 for the quaternion
     * @return the number as the file has it
     */
    public long number(ListedRobot robot, int index) {
        long[] track = tracks.get(robot.id());
        return track == null ? 0 : track[index];
    }

    /**
     * Returns where the ball is along an axis.
     *
     * @param index 0 to 2 for x, y, z
     * @return steps of 0.1 mm
     */
    public long ball(int index) {
        return ball[index];
    }

    /** {@return goals of the left and of the right team} */
    public List<Integer> score() {
        return score;
    }

    /** {@return names of the left and of the right team, empty where there is none} */
    public List<String> teams() {
        return teams;
    }

    /** {@return records that say all this to a reader which begins here; the one of kind 7 stands in no file} */
    public byte[] toRecords() {
        ByteSink records = new ByteSink();
        put(RecordingFormat.GAME, game, records);
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
