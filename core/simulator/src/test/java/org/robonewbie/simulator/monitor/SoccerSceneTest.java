package org.robonewbie.simulator.monitor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.robonewbie.simulator.monitor.RecordedMonitorMessages.message;
import static org.robonewbie.simulator.monitor.RecordedMonitorMessages.snapshot;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.monitor.Environment;
import org.robonewbie.protocol.monitor.MonitorMessageWriter;
import org.robonewbie.protocol.monitor.MonitoredGame;
import org.robonewbie.protocol.monitor.MonitoredWorld;
import org.robonewbie.protocol.monitor.TransformNode;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.physics.sparse.SparsePhysicsWorld;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.simulator.world.BallProperties;
import org.robonewbie.simulator.world.LinkMotion;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.simulator.world.SoccerWorld;

class SoccerSceneTest {

    private final SoccerScene scene = new SoccerScene(SoccerParameters.league());
    private final SoccerWorld world = new SoccerWorld(SoccerField.LEAGUE);

    @Test
    void sceneOfTheRecordedMatchIsTheOriginalsByteForByte() {
        List<String> recorded = RecordedMonitorMessages.load();
        MonitoredWorld original = new MonitoredWorld();
        original.read(message(recorded.get(0)));
        MonitorMessageWriter writer = new MonitorMessageWriter(original.environment());

        for (String line : recorded) {
            original.read(message(line));
            MonitorSnapshot snapshot = snapshot(original);
            scene.update(snapshot);
            MessageBuffer ours = line.contains("(RSG ")
                    ? writer.writeFull(snapshot.game(), snapshot.fouls(), scene.nodes())
                    : writer.writePartial(snapshot.game(), snapshot.fouls(), scene.nodes());
            assertThat(ours).hasToString(line);
        }
    }

    @Test
    void emptySceneHasThirtySixNodesWithTheBallAtTheEnd() {
        MonitoredWorld seen = show(List.of());

        assertThat(seen.scene()).hasSize(36);
        assertThat(seen.ball()).containsSame((TransformNode) seen.scene().get(35));
        assertThat(seen.ball().orElseThrow().position().z()).isEqualTo(0.042f);
    }

    @ParameterizedTest
    @EnumSource(RobotType.class)
    void robotOfEachTypeIsKnownToMonitorsWithAllItsLinks(RobotType type) {
        Robot robot = world.addRobot(type);
        PlayerNumber player = new PlayerNumber(TeamSide.RIGHT, 7);

        MonitoredWorld seen = show(List.of(MonitoredRobotState.of(4, robot, Optional.of(player), false)));

        var shown = seen.robot(player).orElseThrow();
        assertThat(shown.type()).isEqualTo(type);
        for (int i = 0; i < robot.nao().links().size(); i++) {
            String link = robot.nao().links().get(i).name();
            assertThat(shown.link(link)
                            .orElseThrow()
                            .position()
                            .distanceTo(robot.linkPose(i).position()))
                    .as(link)
                    .isLessThan(1e-5);
        }
    }

    @Test
    void toesAreCutFromTheFootMesh() {
        Robot robot = world.addRobot(RobotType.TYPE_4);

        scene.update(snapshotOf(List.of(MonitoredRobotState.of(1, robot, Optional.empty(), false))));

        assertThat(fullText())
                .contains("(load models/rfoot.obj) (sSc 0.08 0.0622412 0.08)(resetMaterials matTeam naowhite)")
                .contains("(load models/rfoot.obj) (sSc 0.08 0.0177588 0.04)(resetMaterials matTeam naowhite)");
    }

    @Test
    void robotsStandInTheOrderOfTheirConnectionsBehindTheBall() {
        MonitoredRobotState first = state(9, 3);
        MonitoredRobotState second = state(2, 1);

        MonitoredWorld seen = show(List.of(first, second));

        assertThat(seen.scene()).hasSize(38);
        assertThat(seen.robots()).extracting(robot -> robot.player().number()).containsExactly(3, 1);
    }

    @Test
    void onlyStructureAndColoursMakeTheSceneNew() {
        assertThat(scene.update(snapshotOf(List.of()))).isFalse();
        assertThat(scene.update(snapshotOf(List.of(unnamed(1))))).isTrue();
        assertThat(scene.update(snapshotOf(List.of(unnamed(1))))).isFalse();
        assertThat(scene.update(snapshotOf(List.of(state(1, 5))))).isTrue();
        assertThat(scene.update(snapshotOf(List.of(state(1, 5))))).isFalse();
        assertThat(scene.update(snapshotOf(List.of()))).isTrue();
    }

    @Test
    void robotWithoutTeamHasNeitherNumberNorColour() {
        MonitoredWorld seen = show(List.of(unnamed(1)));

        assertThat(seen.robots()).isEmpty();
        assertThat(fullText()).contains("(resetMaterials matNum matTeam matType0 naowhite)");
    }

    @Test
    void selectedRobotShowsItsMarker() {
        show(List.of(state(1, 5)));
        assertThat(fullText()).contains("(setVisible 0) (setTransparent) (load StdUnitCylinder 1 1)");
        Robot robot = world.robots().get(0);

        scene.update(snapshotOf(
                List.of(MonitoredRobotState.of(1, robot, Optional.of(new PlayerNumber(TeamSide.LEFT, 5)), true))));

        assertThat(fullText()).contains("(setVisible 1) (setTransparent) (load StdUnitCylinder 1 1)");
    }

    @Test
    void smallPitchIsDrawnToItsSize() {
        SoccerScene small = new SoccerScene(SoccerParameters.beginner());

        String text = new MonitorMessageWriter(new Environment(List.of(), List.of()))
                .writeFull(MonitoredGame.UNKNOWN, List.of(), small.nodes())
                .toString();

        assertThat(text)
                .contains("(load models/naosoccerfield.obj) (sSc 1 1 1)")
                .contains("(load models/leftsoccergoal.obj) (sSc 1.48 0.88 0.48)")
                .contains("(SLT 1 0 0 0 0 1 0 0 0 0 1 0 -6.2 0 0.4 1)");
        assertThat(small.nodes()).hasSize(36);
    }

    @Test
    void thingsStandBehindTheBallAndBeforeTheRobots() {
        SoccerWorld hill =
                new SoccerWorld(SoccerField.LEAGUE, BallProperties.STANDARD, new SparsePhysicsWorld(), Landscape.SLOPE);

        scene.update(MonitorSnapshot.of(MonitoredGame.UNKNOWN, List.of(), hill, List.of(state(1, 5))));

        assertThat(scene.nodes()).hasSize(36 + 4 + 1);
        assertThat(scene.nodes().get(37).position().x())
                .isEqualTo((float) Landscape.SLOPE.things().get(1).centre().x());
        assertThat(fullText()).contains("(load StdUnitBox) (sSc 0.7 2 0.104587)");
    }

    @Test
    void pushedThingNeedsNoFullMessage() {
        SoccerWorld pushing =
                new SoccerWorld(SoccerField.LEAGUE, BallProperties.STANDARD, new SparsePhysicsWorld(), Landscape.BOX);
        boolean first = scene.update(MonitorSnapshot.of(MonitoredGame.UNKNOWN, List.of(), pushing, List.of()));
        BodyPose place = BodyPose.of(new Pose(new Vector3(2, 1, 0.2), Rotation.NONE));
        pushing.things().place(0, LinkMotion.between(place, place, 0));

        boolean second = scene.update(MonitorSnapshot.of(MonitoredGame.UNKNOWN, List.of(), pushing, List.of()));

        assertThat(first).isTrue();
        assertThat(second).isFalse();
        assertThat(scene.nodes().get(36).position().x()).isEqualTo(2f);
    }

    @Test
    void modelAndFigureHaveTheSameLinks() {
        for (RobotType type : RobotType.values()) {
            assertThat(new RobotFigure(type).root().children())
                    .hasSameSizeAs(NaoModel.of(type).links());
        }
    }

    private MonitoredRobotState unnamed(int id) {
        return MonitoredRobotState.of(id, world.addRobot(RobotType.TYPE_0), Optional.empty(), false);
    }

    private MonitoredRobotState state(int id, int number) {
        return MonitoredRobotState.of(
                id, world.addRobot(RobotType.TYPE_0), Optional.of(new PlayerNumber(TeamSide.LEFT, number)), false);
    }

    private MonitorSnapshot snapshotOf(List<MonitoredRobotState> robots) {
        return MonitorSnapshot.of(MonitoredGame.UNKNOWN, List.of(), world, robots);
    }

    private MonitoredWorld show(List<MonitoredRobotState> robots) {
        scene.update(snapshotOf(robots));
        MonitoredWorld seen = new MonitoredWorld();
        assertThat(seen.read(message(fullText()))).isTrue();
        return seen;
    }

    private String fullText() {
        return new MonitorMessageWriter(new Environment(List.of(), List.of()))
                .writeFullForNewcomer(MonitoredGame.UNKNOWN, scene.nodes())
                .toString();
    }
}
