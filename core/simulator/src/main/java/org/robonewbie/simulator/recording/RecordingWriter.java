package org.robonewbie.simulator.recording;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalInt;
import java.util.function.IntFunction;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.SimSparkFrame;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.effector.EffectorCommand.SetHingeSpeed;
import org.robonewbie.robot.RobotModel;
import org.robonewbie.robot.RobotState;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.json.RobotModelJson;

/**
 * A writer of recordings, which contain the changes in each cycle to the game, the ball, the robots and their commands.
 * Identical runs produce identical bytes. Commands are optional, because sources such as the log of another server lack
 * them.
 */
public final class RecordingWriter implements AutoCloseable {

    private static final int CYCLES_PER_FLUSH = 50;

    private final RecordingTarget target;
    private final RecordSink sink;
    private final ByteSink changed = new ByteSink();
    private final List<String> others = new ArrayList<>();
    private final DeltaTrack ballTrack = new DeltaTrack(RecordingFormat.NUMBERS_PER_POSE);
    private final Map<Integer, RobotTrack> robotTracks = new HashMap<>();
    private final ThingTrack things = new ThingTrack();
    private final IdentityHashMap<RobotModel, Integer> models = new IdentityHashMap<>();
    private byte[] lastRobots = {};
    private long lastPlayCycles;

    private RecordingWriter(RecordingTarget target) {
        this.target = target;
        this.sink = new RecordSink(target);
    }

    /**
     * Starts a recording.
     *
     * @param target receives the bytes
     * @param header {@code name=value} lines that describe the run
     * @return the writer
     */
    public static RecordingWriter open(RecordingTarget target, List<String> header) {
        RecordingWriter writer = new RecordingWriter(target);
        writer.sink.begin(header);
        return writer;
    }

    /**
     * Writes one cycle without commands.
     *
     * @param snapshot the world at the end of the cycle
     * @param events match events, such as {@code goal left Stars}
     */
    public void write(WorldSnapshot snapshot, List<String> events) {
        write(snapshot, events, robot -> List.of());
    }

    /**
     * Writes one cycle.
     *
     * @param snapshot the world at the end of the cycle
     * @param events match events, such as {@code goal left Stars}
     * @param commands supplies the commands for a robot, given its index in the snapshot
     */
    public void write(WorldSnapshot snapshot, List<String> events, IntFunction<List<EffectorCommand>> commands) {
        events.forEach(sink::putEvent);
        sink.putGame(
                snapshot.playMode(),
                snapshot.half(),
                snapshot.scoreLeft(),
                snapshot.scoreRight(),
                snapshot.teamLeft(),
                snapshot.teamRight());
        writeModels(snapshot.robots());
        writeRobots(snapshot.robots());
        for (int i = 0; i < snapshot.robots().size(); i++) {
            writeCommands(snapshot.robots().get(i), commands.apply(i));
        }
        things.write(snapshot.things(), sink);
        writeCycle(snapshot);
        sink.send();
        if (snapshot.cycle() % CYCLES_PER_FLUSH == 0) {
            target.flush();
        }
    }

    /** {@return the SHA-256 hash of the uncompressed recording so far, in 64 hexadecimal digits} */
    public String sha256() {
        return sink.sha256();
    }

    @Override
    public void close() {
        target.close();
    }

    /** The values of one robot in the last cycle. */
    private static final class RobotTrack {

        final DeltaTrack poses;
        final long[] speeds;

        RobotTrack(int hinges) {
            poses = new DeltaTrack(RecordingFormat.NUMBERS_PER_POSE + hinges);
            speeds = new long[hinges];
        }
    }

    /** Defines the models of robots that are not NAOs before they appear in a roster. */
    private void writeModels(List<RobotSnapshot> robots) {
        for (RobotSnapshot robot : robots) {
            if (robot.state() instanceof RobotState.OfModel other && !models.containsKey(other.model())) {
                models.put(other.model(), RecordingFormat.NAO_TYPES + models.size());
                ByteSink payload = sink.newPayload();
                payload.putUnsigned(type(robot));
                payload.putUnsigned(other.joints());
                payload.putText(RobotModelJson.write(other.model()).toString());
                sink.put(RecordingFormat.MODEL);
            }
        }
    }

    private int type(RobotSnapshot robot) {
        return robot.state() instanceof RobotState.OfNao nao
                ? nao.body().type().ordinal()
                : Objects.requireNonNull(models.get(robot.state().model()));
    }

    private void writeRobots(List<RobotSnapshot> robots) {
        ByteSink payload = sink.newPayload();
        payload.putUnsigned(robots.size());
        for (RobotSnapshot robot : robots) {
            payload.putUnsigned(robot.id());
            payload.putUnsigned(type(robot));
            payload.putUnsigned(robot.side().map(TeamSide::ordinal).orElse(-1) + 1);
            payload.putUnsigned(robot.number());
            payload.putText(robot.team());
        }
        boolean noneYet = robots.isEmpty() && lastRobots.length == 0;
        boolean same = Arrays.equals(payload.bytes(), 0, payload.length(), lastRobots, 0, lastRobots.length);
        if (!noneYet && !same) {
            lastRobots = Arrays.copyOf(payload.bytes(), payload.length());
            sink.put(RecordingFormat.ROBOTS);
        }
    }

    private void writeCommands(RobotSnapshot robot, List<EffectorCommand> commands) {
        if (!commands.isEmpty()) {
            ByteSink payload = sink.newPayload();
            payload.putUnsigned(robot.id());
            if (putCommands(robot, commands, payload)) {
                sink.put(RecordingFormat.COMMANDS);
            }
        }
    }

    /** Writes changed hinge speeds and other commands; returns false if there were none. */
    private boolean putCommands(RobotSnapshot robot, List<EffectorCommand> commands, ByteSink payload) {
        long[] speeds = track(robot).speeds;
        NaoModel model = NaoModel.of(robot.type());
        others.clear();
        changed.clear();
        int changes = 0;
        for (EffectorCommand command : commands) {
            if (command instanceof SetHingeSpeed speed) {
                changes += putSpeed(speeds, model, speed);
            } else {
                others.add(command.toString());
            }
        }
        payload.putUnsigned(changes);
        payload.putBytes(changed.bytes(), changed.length());
        payload.putUnsigned(others.size());
        others.forEach(payload::putText);
        return changes > 0 || !others.isEmpty();
    }

    /** Appends a speed if it has changed; returns the number of speeds appended, 0 or 1. */
    private int putSpeed(long[] speeds, NaoModel model, SetHingeSpeed command) {
        OptionalInt hinge = model.hingeIndex(command.effectorName());
        long steps = PortableMath.round(command.radiansPerSecond() * RecordingFormat.STEPS_PER_RADIAN);
        if (hinge.isEmpty() || steps == speeds[hinge.getAsInt()]) {
            return 0;
        }
        changed.putUnsigned(hinge.getAsInt());
        changed.putSigned(steps);
        speeds[hinge.getAsInt()] = steps;
        return 1;
    }

    private void writeCycle(WorldSnapshot snapshot) {
        ByteSink payload = sink.newPayload();
        payload.putUnsigned(snapshot.cycle());
        long playCycles = PortableMath.round(snapshot.gameTime() * 50);
        payload.putSigned(playCycles - lastPlayCycles);
        lastPlayCycles = playCycles;
        ballTrack.putPose(0, new Pose(snapshot.ballPosition(), snapshot.ballRotation()), payload);
        for (RobotSnapshot robot : snapshot.robots()) {
            DeltaTrack track = track(robot).poses;
            RobotState state = robot.state();
            track.putPose(0, SimSparkFrame.linkFromBody(state.torso()), payload);
            int hinges = state.joints();
            for (int i = 0; i < hinges; i++) {
                double degrees = state.degrees(i);
                track.put(RecordingFormat.NUMBERS_PER_POSE + i, degrees, RecordingFormat.STEPS_PER_DEGREE, payload);
            }
        }
        sink.put(RecordingFormat.CYCLE);
    }

    private RobotTrack track(RobotSnapshot robot) {
        int hinges = robot.state().joints();
        RobotTrack known = robotTracks.get(robot.id());
        if (known != null && known.speeds.length == hinges) {
            return known;
        }
        RobotTrack track = new RobotTrack(hinges);
        robotTracks.put(robot.id(), track);
        return track;
    }
}
