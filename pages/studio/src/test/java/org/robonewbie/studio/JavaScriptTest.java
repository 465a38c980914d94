package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.Gson;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.kinematics.SimSparkFrame;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.JointSpace;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.file.MotionFiles;
import org.robonewbie.nao.text.DecodedText;
import org.robonewbie.nao.text.UndecodableTextException;
import org.robonewbie.robot.BoosterT1;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.file.RecordingFile;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.recording.RecordedCycle;
import org.robonewbie.simulator.recording.RecordingReader;

/** Runs the tests of the page's scripts in {@code src/test/javascript}. */
class JavaScriptTest {

    @Test
    void scriptsPassTheirTests(@TempDir Path folder) throws Exception {
        Path node = Tool.NODE.orSkip();
        writeFrame(folder);
        writeRobot(folder);
        TouchingLimbs.write(folder.resolve("touching.json"));
        writeRecording(folder);
        WrittenTelemetry.write(folder.resolve("telemetry.json"));
        writeMotions(Files.createDirectory(folder.resolve("motions")));
        writeTexts(folder.resolve("texts.json"));

        run(folder, List.of(node.toString(), "src/test/javascript/all.js"));
    }

    @Tag("slow")
    @Test
    void scriptsPassTheTypeCheck(@TempDir Path folder) throws Exception {
        run(folder, nodeTool("typescript/bin/tsc", "--project", "jsconfig.json"));
    }

    @Tag("slow")
    @Test
    void scriptsPassTheLinter(@TempDir Path folder) throws Exception {
        run(folder, nodeTool("eslint/bin/eslint.js", "--max-warnings", "0", "."));
    }

    @Tag("slow")
    @Test
    void scriptsPagesAndStyleSheetsAreFormatted(@TempDir Path folder) throws Exception {
        run(folder, nodeTool("prettier/bin/prettier.cjs", "--check", "."));
    }

    /** The command line of a tool that {@code npm install} installs; skips the test if it is missing. */
    private static List<String> nodeTool(String script, String... arguments) {
        Path node = Tool.NODE.orSkip();
        Path path = NodeTool.require(script);
        return Stream.concat(Stream.of(node.toString(), path.toString()), Stream.of(arguments))
                .toList();
    }

    private static void run(Path folder, List<String> command) throws IOException, InterruptedException {
        Path output = folder.resolve("output.txt");
        ProcessBuilder builder =
                new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(output.toFile());
        builder.environment().put("STUDIO_FRAME_FOLDER", folder.toString());
        int exitCode = builder.start().waitFor();

        assertThat(exitCode).as(() -> read(output)).isZero();
        assertThat(read(output)).doesNotContain("run by Maven");
    }

    private static String read(Path file) {
        try {
            return Files.readString(file, StandardCharsets.UTF_8);
        } catch (IOException e) {
            return e.toString();
        }
    }

    /** Writes a scene and its frame as the server does, and the expected values. */
    private static void writeFrame(Path folder) throws IOException {
        try (TestSimulator simulation = new TestSimulator()) {
            simulation
                    .withRobot(RobotType.TYPE_0, TeamSide.LEFT, 1, -2, 1, 30, Map.of(Joint.RIGHT_SHOULDER_PITCH, -60.0))
                    .withRobot(RobotType.TYPE_3, TeamSide.RIGHT, 2, 2, -1, 200, Posture.STANDING)
                    .withRobot(RobotType.TYPE_4, TeamSide.RIGHT, 11, 0, 2, -90, Posture.STANDING);
            WorldSnapshot world = simulation.latest();
            WorldSnapshot snapshot = new WorldSnapshot(
                    world.cycle(),
                    12.34,
                    PlayMode.CORNER_KICK_RIGHT,
                    world.teamLeft(),
                    world.teamRight(),
                    1,
                    2,
                    2,
                    world.ballPosition(),
                    world.ballRotation(),
                    world.robots(),
                    Landscape.SLOPE.things(),
                    true,
                    SimulationControl.AS_FAST_AS_POSSIBLE,
                    3.5);
            Files.writeString(
                    folder.resolve("scene.json"),
                    SceneDescriptionWriter.write(
                            SceneDescription.of(
                                    simulation.control(),
                                    new PuppetService(simulation.control(), Optional.empty()),
                                    snapshot),
                            7));
            ByteBuffer frame = StateFrame.write(snapshot, 7);
            byte[] bytes = new byte[frame.remaining()];
            frame.get(bytes);
            Files.write(folder.resolve("frame.bin"), bytes);
            Map<String, Object> truth = Map.of(
                    "cycle", snapshot.cycle(),
                    "gameTime", snapshot.gameTime(),
                    "playMode", snapshot.playMode().simSparkName(),
                    "scoreRight", snapshot.scoreRight(),
                    "thingPoses",
                            snapshot.things().stream()
                                    .map(thing -> numbers(
                                                    thing.centre(), thing.pose().rotation())
                                            .toList())
                                    .toList(),
                    "linkPoses",
                            snapshot.robots().stream()
                                    .map(robot -> robot.body().limbs().links().stream()
                                            .flatMap(JavaScriptTest::numbers)
                                            .toList())
                                    .toList());
            Files.writeString(folder.resolve("truth.json"), new Gson().toJson(truth));
        }
    }

    /** Position and quaternion of a link in SimSpark's axes, as in the page. */
    private static Stream<Double> numbers(Pose link) {
        return numbers(link.position(), SimSparkFrame.linkFromBody(link).rotation());
    }

    private static Stream<Double> numbers(Vector3 place, Rotation turn) {
        return Stream.of(place.x(), place.y(), place.z(), turn.w(), turn.x(), turn.y(), turn.z());
    }

    /** Writes the robot's description as the server sends it to pages. */
    private static void writeRobot(Path folder) throws IOException {
        try (TestSimulator simulation = new TestSimulator();
                StudioServer studio = StudioServer.start(
                        simulation.control(),
                        0,
                        AccessToken.random(),
                        new StudioFolders(folder.resolve("none"), Optional.empty()))) {
            String answer = RawHttp.send(
                    studio.address(),
                    "GET /api/robot HTTP/1.1",
                    "Host: " + studio.address().getAuthority(),
                    "Cookie: " + StudioCookie.of(studio.oneTimeAddress()));
            Files.writeString(folder.resolve("robot.json"), answer.substring(answer.indexOf("\r\n\r\n") + 4));
        }
    }

    /** Writes a recording, and its content as read by Java. */
    private static void writeRecording(Path folder) throws IOException {
        Path file = folder.resolve("run.rec");
        RecordedRun.write(file);
        List<Map<String, Object>> truth = new ArrayList<>();
        try (RecordingReader reader = RecordingFile.read(file)) {
            for (Optional<RecordedCycle> cycle = reader.next(); cycle.isPresent(); cycle = reader.next()) {
                WorldSnapshot snapshot = cycle.get().snapshot();
                Vector3 ball = snapshot.ballPosition();
                truth.add(Map.of(
                        "cycle", snapshot.cycle(),
                        "scoreLeft", snapshot.scoreLeft(),
                        "ball", List.of(ball.x(), ball.y(), ball.z()),
                        "degrees",
                                snapshot.robots().stream()
                                        .map(robot -> robot.body().hingeDegrees())
                                        .toList(),
                        "torsos",
                                snapshot.robots().stream()
                                        .map(robot ->
                                                numbers(robot.body().torso()).toList())
                                        .toList()));
            }
        }
        Files.writeString(folder.resolve("run.json"), new Gson().toJson(truth));
    }

    /** Writes various motion files, and how the agent's parser reads them. */
    private static void writeMotions(Path folder) throws IOException {
        Random random = new Random(5);
        for (int i = 0; i < 80; i++) {
            JointSpace space = i < 60 ? JointSpace.NAO : BoosterT1.MODEL.jointSpace();
            byte[] content = randomMotion(random, space);
            Path path = folder.resolve(i + ".txt");
            Files.write(path, content);
            MotionFile file = MotionFiles.load(path, space);
            double angle = Math.round(random.nextDouble() * 1000) / 100.0;
            List<String> changed = new ArrayList<>();
            List<double[]> keyframes = new ArrayList<>();
            for (Keyframe keyframe : file.keyframes()) {
                int index = keyframes.size();
                double[] degrees = keyframe.posture().toArray();
                degrees[index % space.size()] = angle;
                Keyframe next = new Keyframe(1234, org.robonewbie.nao.motion.Posture.of(space, degrees));
                changed.add(file.withKeyframe(index, next).text());
                double[] numbers = new double[1 + space.size()];
                numbers[0] = keyframe.durationMillis();
                System.arraycopy(keyframe.posture().toArray(), 0, numbers, 1, space.size());
                keyframes.add(numbers);
            }
            Map<String, Object> truth = Map.of(
                    "keyframes",
                    keyframes,
                    "errors",
                    file.errors().size(),
                    "angle",
                    angle,
                    "changed",
                    changed,
                    "robot",
                    space.robot(),
                    "joints",
                    space.size());
            Files.writeString(folder.resolve(i + ".json"), new Gson().toJson(truth));
        }
    }

    /** Writes various byte sequences, and how the agent's decoder reads them. */
    private static void writeTexts(Path file) throws IOException {
        Random random = new Random(7);
        List<Map<String, String>> texts = new ArrayList<>();
        for (int i = 0; i < 3000; i++) {
            byte[] bytes = randomBytes(random);
            texts.add(Map.of("hex", HexFormat.of().formatHex(bytes), "said", said(bytes)));
        }
        Files.writeString(file, new Gson().toJson(texts));
    }

    private static String said(byte[] bytes) {
        try {
            DecodedText text = DecodedText.of(bytes);
            return text.encoding() + " " + text.hasByteOrderMark() + " " + text.content() + "\n"
                    + text.note().orElse("");
        } catch (UndecodableTextException refused) {
            return String.valueOf(refused.getMessage());
        }
    }

    private static byte[] randomBytes(Random random) {
        List<String> parts = List.of(
                "61",
                "0A",
                "0D",
                "0D0A",
                "20",
                "C3BC",
                "E282AC",
                "F09F918B",
                "FC",
                "DF",
                "80",
                "81",
                "A0",
                "00",
                "EDA0BD",
                "E08080",
                "F4908080",
                "FF",
                "C3",
                "E282",
                "01",
                "7F",
                "09",
                "FEFF",
                "FFFE",
                "EFBBBF",
                "D83D",
                "DC4B");
        StringBuilder hex =
                new StringBuilder(List.of("", "", "EFBBBF", "FFFE", "FEFF").get(random.nextInt(5)));
        int harmless = 6 + random.nextInt(parts.size() - 5);
        for (int i = random.nextInt(9); i > 0; i--) {
            hex.append(parts.get(random.nextInt(harmless)));
        }
        return HexFormat.of().parseHex(hex);
    }

    private static byte[] randomMotion(Random random, JointSpace space) {
        List<String> ends = List.of("\n", "\r\n", "\r");
        List<String> others = List.of("", "  ", "// Zoë: 1", "\t// x", "abc", "500 1 2", "5.5 1", "1e3", "500 1,5");
        StringBuilder text = new StringBuilder(random.nextInt(6) == 0 ? "\uFEFF" : "");
        if (!space.equals(JointSpace.NAO)) {
            text.append(List.of("// robot: ", "\t//robot:", " //  robot:  ").get(random.nextInt(3)))
                    .append(space.robot())
                    .append(ends.get(random.nextInt(ends.size())));
        }
        int lines = random.nextInt(9);
        for (int line = 0; line < lines; line++) {
            boolean isFrame = random.nextBoolean();
            text.append(isFrame ? randomFrame(random, space.size()) : others.get(random.nextInt(others.size())));
            boolean isLast = line == lines - 1 && random.nextBoolean();
            text.append(isLast ? "" : ends.get(random.nextInt(ends.size())));
        }
        Charset charset = random.nextInt(4) == 0 ? StandardCharsets.ISO_8859_1 : StandardCharsets.UTF_8;
        return text.toString()
                .replace("\uFEFF", charset.newEncoder().canEncode("\uFEFF") ? "\uFEFF" : "")
                .getBytes(charset);
    }

    private static String randomFrame(Random random, int joints) {
        List<String> forms = List.of("%.0f", "%.1f", "%.4f", "%+.2f", "%e", "%.3f0");
        StringBuilder text = new StringBuilder(random.nextInt(4) == 0 ? " \t" : "");
        text.append(random.nextInt(3000));
        for (int i = 0; i < joints; i++) {
            text.append(random.nextInt(5) == 0 ? "\t " : " ");
            text.append(String.format(
                    Locale.ROOT, forms.get(random.nextInt(forms.size())), random.nextDouble() * 200 - 100));
        }
        return text.append(random.nextInt(3) == 0 ? "  // käse 1 2" : "").toString();
    }
}
