package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.model.MassDistribution;
import org.robonewbie.nao.model.Shape;
import org.robonewbie.nao.motion.Interpolation;
import org.robonewbie.nao.motion.JointStates;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.MotionPlayer;
import org.robonewbie.nao.motion.Motors;
import org.robonewbie.nao.motion.file.MotionFiles;
import org.robonewbie.robot.Motor;
import org.robonewbie.robot.PlacedShape;
import org.robonewbie.robot.RobotBody;
import org.robonewbie.robot.RobotJoint;
import org.robonewbie.robot.RobotModel;
import org.robonewbie.robot.RobotState;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.PitchDetails;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.cycle.SteppedSimulator;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.file.RecordingFile;
import org.robonewbie.simulator.recording.RecordedCycle;
import org.robonewbie.simulator.recording.RecordingReader;
import org.robonewbie.simulator.recording.RecordingTarget;
import org.robonewbie.simulator.state.WorldState;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.studio.motion.RobotDescription;

/** A robot that is defined in this file only stands, moves and falls in the world, and is recorded, replayed and shown. */
class MadeUpRobotTest {

    private static final Vector3 Y = new Vector3(0, 1, 0);
    private static final Vector3 Z = new Vector3(0, 0, 1);

    /** A box on two legs, with a head that turns and two arms that swing. */
    private static final RobotModel TIN_MAN = new RobotModel(
            "TinMan",
            List.of(
                    body("trunk", -1, at(0, 0, 0), 2, Pose.ORIGIN, box(0.16, 0.26, 0.3, Pose.ORIGIN)),
                    body("head", 0, at(0, 0, 0.16), 0.3, at(0, 0, 0.08), sphere(0.08, at(0, 0, 0.08))),
                    arm("left arm", 0.16),
                    arm("right arm", -0.16),
                    leg("left leg", 0.08),
                    leg("right leg", -0.08)),
            List.of(
                    joint(0, "neck", 1, Z, 90),
                    joint(1, "left shoulder", 2, Y, 170),
                    joint(2, "right shoulder", 3, Y, 170),
                    joint(3, "left hip", 4, Y, 60),
                    joint(4, "right hip", 5, Y, 60)),
            0.45);

    private static final int LEFT_SHOULDER = 1;
    private static final Vector3 START = new Vector3(-1, 0.5, 0.46);

    @TempDir
    private Path folder;

    @Test
    void standsOnItsFeet() {
        try (SteppedSimulator simulator = simulator(RecordingTarget.NONE)) {
            Robot robot = standing(simulator);

            assertThat(robot.isStanding()).isTrue();
            assertThat(robot.tiltDegrees()).isLessThan(1);
            assertThat(robot.torso().position().z()).isCloseTo(TIN_MAN.stanceHeight(), within(0.01));
            assertThat(robot.boundingBox().min().z()).isCloseTo(0, within(0.01));
            assertThat(robot.boundingBox().max().z()).isCloseTo(0.45 + 0.16 + 0.16, within(0.01));
            assertThat(robot.headingDegrees()).isCloseTo(0, within(1.0));
        }
    }

    @Test
    void movesAJointAtTheCommandedSpeedUpToTheEndOfItsRange() {
        try (SteppedSimulator simulator = simulator(RecordingTarget.NONE)) {
            Robot robot = standing(simulator);

            raiseLeftArm(simulator, robot, 90);
            double afterOneSecond = robot.jointDegrees(LEFT_SHOULDER);
            raiseLeftArm(simulator, robot, 100);

            assertThat(afterOneSecond).isCloseTo(-90, within(0.1));
            assertThat(robot.jointDegrees(LEFT_SHOULDER)).isCloseTo(-170, within(2.5));
            assertThat(robot.jointDegrees(neck())).isCloseTo(0, within(0.1));
        }
    }

    @Test
    void movesNoJointFasterThanItsMotor() {
        try (SteppedSimulator simulator = simulator(RecordingTarget.NONE)) {
            Robot robot = standing(simulator);

            robot.setMotorSpeed(LEFT_SHOULDER, Double.NEGATIVE_INFINITY);
            cycles(simulator, 10);

            assertThat(robot.jointDegrees(LEFT_SHOULDER)).isCloseTo(-360 * 0.2, within(0.5));
        }
    }

    @Test
    void playsAMotionFileThatNamesIt() throws IOException {
        MotionFile file = motionFile("// robot: TinMan\n600 45 -90 0 0 0\n400 45 -90 -60 0 0\n");
        try (SteppedSimulator simulator = simulator(RecordingTarget.NONE)) {
            Robot robot = standing(simulator);

            play(file, simulator, robot);

            assertThat(robot.state().degrees(0)).isCloseTo(45, within(1.0));
            assertThat(robot.state().degrees(LEFT_SHOULDER)).isCloseTo(-90, within(1.0));
            assertThat(robot.state().degrees(2)).isCloseTo(-60, within(1.0));
            assertThat(robot.isStanding()).isTrue();
        }
    }

    @Test
    void writesTheMotionItHasRead() throws IOException {
        MotionFile file = motionFile("// robot: TinMan\n600 45 -90 0 0 0\n");

        MotionFile written = MotionFile.of(file.motion());

        assertThat(written.text()).isEqualTo(file.text());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            // robot: T1                | line 2, column 11: found "T1", expected "TinMan": this motion is for the robot T1
            // made for a NAO           | line 1, column 1: no line "// robot: TinMan": this motion is for the robot NAO
            """)
    void refusesAMotionFileOfAnotherRobot(String head, String problem) throws IOException {
        MotionFile file = motionFile("\n" + head + "\n600 45 -90 0 0 0\n");

        assertThatThrownBy(file::motion)
                .hasMessageStartingWith("salute.txt " + problem + ", not for TinMan. Play it with a ")
                .hasMessageEndingWith(", or choose a motion for TinMan");
    }

    @Test
    void motionFileIsRefusedByANao() {
        MotionFile file = MotionFile.parse("salute.txt", "// robot: TinMan\n600 45 -90 0 0 0\n");

        assertThatThrownBy(file::motion)
                .hasMessage(
                        "salute.txt line 1, column 11: found \"TinMan\", expected \"NAO\": this motion is for the robot TinMan,"
                                + " not for NAO. Play it with a TinMan, or choose a motion for NAO");
    }

    @Test
    void motionIsRefusedByTheMotorsOfAnotherRobot() throws IOException {
        Motion motion = motionFile("// robot: TinMan\n600 45 -90 0 0 0\n").motion();
        MotionPlayer player = new MotionPlayer(motion, Interpolation.LINEAR);

        assertThatThrownBy(() -> player.step(new Motors(new JointStates())))
                .hasMessage(
                        "Motion salute is for the robot TinMan, but the motors are those of NAO. Play a motion for that robot.");
    }

    @Test
    void fallsWhenItSwingsItsLegsForward() {
        try (SteppedSimulator simulator = simulator(RecordingTarget.NONE)) {
            Robot robot = standing(simulator);

            fall(simulator, robot);

            assertThat(robot.isFallen()).isTrue();
            assertThat(robot.isStanding()).isFalse();
            assertThat(simulator.report().robots().get(0).falls()).isEqualTo(1);
        }
    }

    @Test
    void continuesFromASavedStateToTheSameBits() {
        try (SteppedSimulator simulator = simulator(RecordingTarget.NONE)) {
            Robot robot = standing(simulator);
            raiseLeftArm(simulator, robot, 90);
            WorldState saved = simulator.save();
            fall(simulator, robot);
            Pose lying = robot.torso().toPose();

            simulator.restore(saved);
            fall(simulator, robot);

            assertThat(robot.torso().toPose()).isEqualTo(lying);
        }
    }

    @Test
    void isReplayedAsItWasRecorded() throws IOException {
        Path file = folder.resolve("tin man.rec");

        RobotState last = record(file);

        List<WorldSnapshot> replayed = read(file);
        RobotState state = replayed.get(replayed.size() - 1).robots().get(0).state();
        assertThat(state.model().name()).isEqualTo("TinMan");
        assertThat(state.model().joints()).extracting(RobotJoint::name).containsExactlyElementsOf(names());
        assertThat(state.torso().position().distanceTo(last.torso().position())).isLessThan(0.001);
        for (int joint = 0; joint < last.joints(); joint++) {
            assertThat(state.degrees(joint)).isCloseTo(last.degrees(joint), within(0.01));
        }
        assertThat(state.isFallen()).isTrue();
        assertThat(replayed.get(100).robots().get(0).state().isStanding()).isTrue();
    }

    @Test
    void isDescribedToPagesByItsShapes() {
        try (SteppedSimulator simulator = simulator(RecordingTarget.NONE)) {
            raiseLeftArm(simulator, standing(simulator), 90);
            WorldSnapshot snapshot = simulator.snapshot(false, 1);

            JsonObject scene = JsonParser.parseString(SceneDescriptionWriter.write(sceneOf(snapshot), 0))
                    .getAsJsonObject();
            ByteBuffer frame = StateFrame.write(snapshot, 0).order(ByteOrder.LITTLE_ENDIAN);

            JsonObject model = scene.getAsJsonObject("models").getAsJsonObject("TYPE_5");
            assertThat(model.get("name").getAsString()).isEqualTo("TinMan");
            assertThat(model.getAsJsonArray("links")).hasSize(6);
            assertThat(model.getAsJsonArray("hinges")).hasSize(5);
            frame.position(frame.limit() - TIN_MAN.joints().size() * Short.BYTES);
            assertThat(frame.getShort()).isCloseTo((short) 0, within((short) 10));
            assertThat(frame.getShort()).isCloseTo((short) -9000, within((short) 10));
        }
    }

    @Test
    void isDescribedToTheMotionEditor() {
        JsonObject description =
                JsonParser.parseString(RobotDescription.write(TIN_MAN)).getAsJsonObject();

        assertThat(description.getAsJsonArray("joints"))
                .extracting(joint -> joint.getAsJsonObject().get("name").getAsString())
                .containsExactlyElementsOf(names());
        assertThat(description.getAsJsonObject("model").getAsJsonArray("links")).hasSize(6);
    }

    /** Records a run to the file that the argument names, for a test of the page. */
    public static void main(String[] args) throws IOException {
        record(Path.of(args[0]));
    }

    @SuppressWarnings("ClosingStandardOutputStreams") // only the recording is closed
    private static RobotState record(Path file) throws IOException {
        try (SteppedSimulator simulator = simulator(RecordingFile.open(file, System.err::println))) {
            Robot robot = standing(simulator);
            raiseLeftArm(simulator, robot, 90);
            fall(simulator, robot);
            return robot.state();
        }
    }

    private static SteppedSimulator simulator(RecordingTarget recording) {
        return SteppedSimulator.start(WorldSettings.beginner().withSeed(1), recording, Console.silent());
    }

    private static Robot standing(SteppedSimulator simulator) {
        Robot robot = simulator.world().addRobot(TIN_MAN);
        robot.moveUpright(START, -90);
        cycles(simulator, 100);
        return robot;
    }

    private static RobotJoint neck() {
        return TIN_MAN.joint("neck").orElseThrow();
    }

    private static void raiseLeftArm(SteppedSimulator simulator, Robot robot, double degreesPerSecond) {
        robot.setMotorSpeed(LEFT_SHOULDER, PortableMath.toRadians(-degreesPerSecond));
        cycles(simulator, 50);
        robot.setMotorSpeed(LEFT_SHOULDER, 0);
    }

    private MotionFile motionFile(String text) throws IOException {
        Path file = folder.resolve("salute.txt");
        Files.writeString(file, text);
        return MotionFiles.load(file, TIN_MAN.jointSpace());
    }

    /** Plays a motion. Speeds take effect one cycle after they were calculated, as those of an agent do. */
    private static void play(MotionFile file, SteppedSimulator simulator, Robot robot) {
        JointStates joints = new JointStates(TIN_MAN.jointSpace());
        Motors motors = new Motors(joints);
        MotionPlayer player = MotionPlayer.of(file, 1, Interpolation.LINEAR);
        while (!player.isFinished()) {
            TIN_MAN.joints().forEach(joint -> joints.sense(joint.index(), robot.jointDegrees(joint)));
            player.step(motors);
            motors.endCycle();
            double[] speeds = motors.sentDegreesPerSecond();
            simulator.cycle();
            TIN_MAN.joints()
                    .forEach(joint -> robot.setMotorSpeed(joint, PortableMath.toRadians(speeds[joint.index()])));
        }
        simulator.cycle();
    }

    private static void fall(SteppedSimulator simulator, Robot robot) {
        for (String hip : List.of("left hip", "right hip")) {
            robot.setMotorSpeed(TIN_MAN.joint(hip).orElseThrow(), PortableMath.toRadians(-120));
        }
        cycles(simulator, 100);
    }

    private static void cycles(SteppedSimulator simulator, int count) {
        for (int i = 0; i < count; i++) {
            simulator.cycle();
        }
    }

    private static List<WorldSnapshot> read(Path file) throws IOException {
        List<WorldSnapshot> snapshots = new ArrayList<>();
        try (RecordingReader reader = RecordingFile.read(file)) {
            for (Optional<RecordedCycle> cycle = reader.next(); cycle.isPresent(); cycle = reader.next()) {
                snapshots.add(cycle.get().snapshot());
            }
        }
        return snapshots;
    }

    private static SceneDescription sceneOf(WorldSnapshot snapshot) {
        List<RobotModel> models = List.of(TIN_MAN);
        List<SceneDescription.Player> players = snapshot.robots().stream()
                .map(robot -> SceneDescription.Player.of(robot, models, false))
                .toList();
        return new SceneDescription(
                SoccerField.BEGINNER,
                PitchDetails.SIMSPARK,
                true,
                true,
                OptionalInt.empty(),
                false,
                Optional.empty(),
                "",
                "",
                models,
                players,
                List.of());
    }

    private static List<String> names() {
        return TIN_MAN.joints().stream().map(RobotJoint::name).toList();
    }

    private static RobotBody arm(String name, double y) {
        return body(name, 0, at(0, y, 0.12), 0.2, at(0, 0, -0.1), capsule(0.025, 0.15, at(0, 0, -0.1)));
    }

    private static RobotBody leg(String name, double y) {
        return body(
                name,
                0,
                at(0, y, -0.15),
                0.6,
                at(0.01, 0, -0.2),
                box(0.07, 0.07, 0.26, at(0, 0, -0.13)),
                box(0.2, 0.1, 0.04, at(0.02, 0, -0.28)));
    }

    private static RobotBody body(
            String name, int parent, Pose pose, double massKg, Pose centreOfMass, PlacedShape... shapes) {
        Vector3 inertia = MassDistribution.of(shapes[0].shape(), massKg).inertia();
        return new RobotBody(name, parent, pose, massKg, centreOfMass, inertia, List.of(shapes));
    }

    private static RobotJoint joint(int index, String name, int body, Vector3 axis, double range) {
        return new RobotJoint(
                index, name, name, name, body, Vector3.ZERO, axis, -range, range, Motor.Speed.ofDegrees(360), 0);
    }

    private static PlacedShape box(double x, double y, double z, Pose pose) {
        return new PlacedShape(new Shape.Box(new Vector3(x, y, z)), pose, true);
    }

    private static PlacedShape sphere(double radius, Pose pose) {
        return new PlacedShape(new Shape.Sphere(radius), pose, true);
    }

    private static PlacedShape capsule(double radius, double length, Pose pose) {
        return new PlacedShape(new Shape.Capsule(radius, length), pose, true);
    }

    private static Pose at(double x, double y, double z) {
        return new Pose(new Vector3(x, y, z), Rotation.NONE);
    }
}
