package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.Gson;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.WorldSnapshot;

/** Runs the tests of the page's scripts, which live in {@code src/test/javascript}. */
class JavaScriptTest {

    private static final Path COMPILER = Path.of("node_modules", "typescript", "bin", "tsc");

    @Test
    void scriptsPassTheirTests(@TempDir Path folder) throws Exception {
        Path node = Tool.NODE.orSkip();
        writeFrame(folder);

        run(folder, List.of(node.toString(), "--test", "src/test/javascript/"));
    }

    @Test
    void scriptsHaveTheTypesThatTheySay(@TempDir Path folder) throws Exception {
        Path node = Tool.NODE.orSkip();
        boolean installed = Files.exists(COMPILER);
        if (!installed) {
            System.out.println("SKIPPED: the types of the scripts are not checked; run npm install in studio first.");
        }
        Assumptions.assumeTrue(installed, "TypeScript is not installed");

        run(folder, List.of(node.toString(), COMPILER.toString(), "--project", "jsconfig.json"));
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

    /** Writes a scene and its frame as the server does, and the truth to compare with. */
    private static void writeFrame(Path folder) throws IOException {
        try (SmallSimulation simulation = new SmallSimulation()) {
            simulation
                    .withRobot(RobotType.TYPE_0, TeamSide.LEFT, 1, -2, 1, 30, Posture.GREETING)
                    .withRobot(RobotType.TYPE_3, TeamSide.RIGHT, 2, 2, -1, 200, Posture.STANDING)
                    .withRobot(RobotType.TYPE_4, TeamSide.RIGHT, 11, 0, 2, -90, Posture.STANDING);
            WorldSnapshot world = simulation.afterCycles(60);
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
                    world.ballOrientation(),
                    world.robots(),
                    true,
                    SimulationControl.AS_FAST_AS_POSSIBLE,
                    3.5);
            Files.writeString(
                    folder.resolve("scene.json"), SceneWriter.write(Scene.of(simulation.field(), snapshot), 7));
            ByteBuffer frame = StateFrame.write(snapshot, 7);
            byte[] bytes = new byte[frame.remaining()];
            frame.get(bytes);
            Files.write(folder.resolve("frame.bin"), bytes);
            Map<String, Object> truth = Map.of(
                    "cycle", snapshot.cycle(),
                    "gameTime", snapshot.gameTime(),
                    "playMode", snapshot.playMode().simSparkName(),
                    "scoreRight", snapshot.scoreRight(),
                    "linkPoses",
                            snapshot.robots().stream()
                                    .map(robot -> robot.linkPoses())
                                    .toList());
            Files.writeString(folder.resolve("truth.json"), new Gson().toJson(truth));
        }
    }
}
