package org.robonewbie.simulator.recording;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.file.RecordingFile;
import org.robonewbie.simulator.soccer.JoinRefusedException;
import org.robonewbie.simulator.soccer.Match;
import org.robonewbie.simulator.soccer.MatchEvent;
import org.robonewbie.simulator.soccer.Player;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.simulator.world.SoccerWorld;

class RecordingTest {

    @TempDir
    private Path folder;

    private final SoccerWorld world = new SoccerWorld(SoccerParameters.league().field());
    private final Match match = new Match(world, SoccerParameters.league(), 1);

    /** The robot falls: its joints, which are not quite stiff, give way by some millimetres. */
    @Test
    void showsEachCycleAsItWas() throws Exception {
        Path file = folder.resolve("run.rec");
        Player player = match.teams().join("Stars", 7, world.addRobot(RobotType.TYPE_4));
        player.robot().moveUpright(new Vector3(-3, 1, 0.5), -60);
        List<Vector3> torsos = new ArrayList<>();
        List<Vector3> feet = new ArrayList<>();
        record(file, player, 100, torsos, feet);

        List<RecordedCycle> cycles = read(file);

        assertThat(cycles).hasSize(100);
        for (int i = 0; i < 100; i++) {
            RobotSnapshot robot = cycles.get(i).snapshot().robots().get(0);
            assertThat(position(robot, "body")).satisfies(near(torsos.get(i), 0.0001));
            assertThat(position(robot, "rfoot")).satisfies(near(feet.get(i), 0.01));
        }
    }

    @Test
    void keepsGameCommandsAndEvents() throws Exception {
        Path file = folder.resolve("run.rec");
        Player player = match.teams().join("Stars", 7, world.addRobot(RobotType.TYPE_0));
        record(file, player, 2, new ArrayList<>(), new ArrayList<>());

        List<RecordedCycle> cycles = read(file);

        RecordedCycle first = cycles.get(0);
        assertThat(first.snapshot().teamLeft()).isEqualTo("Stars");
        assertThat(first.snapshot().playMode()).isEqualTo(PlayMode.PLAY_ON);
        assertThat(first.snapshot().robots().get(0).number()).isEqualTo(7);
        assertThat(first.snapshot().robots().get(0).side()).contains(TeamSide.LEFT);
        assertThat(first.events()).containsExactly("playmode PlayOn");
        assertThat(first.commands().get(0).others()).containsExactly("Say[text=hello]");
        assertThat(first.commands().get(0).hingeSpeeds()).hasSize(1);
        assertThat(first.commands().get(0).hingeSpeeds().get(0).radiansPerSecond())
                .isCloseTo(-1.5, within(1e-4));
        assertThat(cycles.get(1).commands().get(0).hingeSpeeds()).isEmpty();
        assertThat(cycles.get(1).events()).isEmpty();
    }

    @Test
    void goesOnBehindSpeedsThatNoJointCanHave() throws Exception {
        Path file = folder.resolve("run.rec");
        Player player = match.teams().join("Stars", 7, world.addRobot(RobotType.TYPE_0));
        try (RecordingWriter writer = RecordingWriter.open(RecordingFile.open(file, sentence -> {}), List.of())) {
            int cycle = 0;
            for (double speed : new double[] {1e308, -1e308, 1}) {
                List<EffectorCommand> commands = List.of(new EffectorCommand.SetHingeSpeed("rle4", speed));
                List<Participant> robots =
                        List.of(new Participant(1, Optional.of(player), player.robot(), commands, 0));
                cycle++;
                writer.write(Snapshots.of(cycle, match, world, robots), List.of(), robot -> commands);
            }
        }

        List<RecordedCycle> cycles = read(file);

        assertThat(cycles).extracting(cycle -> cycle.snapshot().cycle()).containsExactly(1L, 2L, 3L);
        assertThat(cycles)
                .extracting(
                        cycle -> cycle.commands().get(0).hingeSpeeds().get(0).radiansPerSecond())
                .satisfiesExactly(
                        speed -> assertThat(speed).isGreaterThan(1e12),
                        speed -> assertThat(speed).isLessThan(-1e12),
                        speed -> assertThat(speed).isCloseTo(1, within(1e-4)));
    }

    @Test
    void headerTellsSeedAndParameters() throws Exception {
        Path file = folder.resolve("run.rec");
        record(
                file,
                match.teams().join("Stars", 1, world.addRobot(RobotType.TYPE_0)),
                1,
                new ArrayList<>(),
                new ArrayList<>());

        try (RecordingReader reader = RecordingFile.read(file)) {
            assertThat(reader.header()).containsEntry("seed", "5").containsEntry("FieldLength", "30");
        }
    }

    @Test
    void cutRecordingCanBeReadUpToTheCut() throws Exception {
        Path file = folder.resolve("run.rec");
        Player player = match.teams().join("Stars", 1, world.addRobot(RobotType.TYPE_0));
        record(file, player, 300, new ArrayList<>(), new ArrayList<>());
        byte[] bytes = Files.readAllBytes(file);
        Files.write(file, Arrays.copyOf(bytes, bytes.length * 2 / 3));

        List<RecordedCycle> cycles = read(file);

        assertThat(cycles.size()).isBetween(50, 280);
    }

    @Test
    void runningRecordingIsKeptAsPart() throws Exception {
        Path file = folder.resolve("run.rec");
        RecordingWriter writer = RecordingWriter.open(RecordingFile.open(file, sentence -> {}), List.of());
        writer.write(Snapshots.of(50, match, world, List.of()), List.of());

        List<RecordedCycle> cycles = read(folder.resolve("run.rec.part"));

        assertThat(Files.exists(file)).isFalse();
        assertThat(cycles).hasSize(1);
        writer.close();
        assertThat(Files.exists(file)).isTrue();
    }

    @Test
    void otherFilesAreRefused() throws IOException {
        Path file = Files.writeString(folder.resolve("motion.txt"), "no recording");

        assertThatThrownBy(() -> RecordingFile.read(file))
                .isInstanceOf(IOException.class)
                .hasMessage("\"" + file + "\" is not a RoboNewbie recording, or it is damaged.");
    }

    @Test
    void missingFolderIsExplained() {
        Path file = folder.resolve("missing").resolve("run.rec");

        assertThatThrownBy(() -> RecordingWriter.open(RecordingFile.open(file, sentence -> {}), List.of()))
                .isInstanceOf(IOException.class)
                .hasMessageStartingWith("The file " + file + " cannot be written: its folder does not exist")
                .hasMessageEndingWith("Choose a file in an existing folder that you may write to.");
    }

    private void record(Path file, Player player, int cycles, List<Vector3> torsos, List<Vector3> feet)
            throws IOException, JoinRefusedException {
        Robot robot = player.robot();
        int foot = robot.nao().linkIndex("rfoot");
        match.setPlayMode(PlayMode.PLAY_ON);
        List<String> header = new ArrayList<>(List.of("seed=5"));
        header.addAll(SoccerParameters.league().assignments());
        try (RecordingWriter writer = RecordingWriter.open(RecordingFile.open(file, sentence -> {}), header)) {
            for (int i = 1; i <= cycles; i++) {
                robot.setMotorSpeed(Joint.RIGHT_KNEE_PITCH, -1.5);
                world.step();
                match.tick();
                List<EffectorCommand> commands =
                        List.of(new EffectorCommand.SetHingeSpeed("rle4", -1.5), new EffectorCommand.Say("hello"));
                List<Participant> robots = List.of(new Participant(1, Optional.of(player), robot, commands, 0));
                writer.write(
                        Snapshots.of(i, match, world, robots),
                        match.events().stream().map(MatchEvent::text).toList(),
                        index -> commands);
                match.clearEvents();
                torsos.add(robot.torso().position());
                feet.add(robot.linkPose(foot).position());
            }
        }
    }

    private static List<RecordedCycle> read(Path file) throws IOException {
        List<RecordedCycle> cycles = new ArrayList<>();
        try (RecordingReader reader = RecordingFile.read(file)) {
            for (Optional<RecordedCycle> cycle = reader.next(); cycle.isPresent(); cycle = reader.next()) {
                cycles.add(cycle.get());
            }
        }
        return cycles;
    }

    private static Vector3 position(RobotSnapshot robot, String link) {
        return robot.body().limbs().link(link).position();
    }

    private static Consumer<Vector3> near(Vector3 expected, double metres) {
        return actual -> assertThat(actual.distanceTo(expected)).isLessThan(metres);
    }
}
