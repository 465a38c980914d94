package org.robonewbie.studio.monitor;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.model.Hinge;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.protocol.monitor.Environment;
import org.robonewbie.protocol.monitor.MonitoredGame;
import org.robonewbie.protocol.monitor.MonitoredRobot;
import org.robonewbie.protocol.monitor.MonitoredWorld;
import org.robonewbie.protocol.monitor.TransformNode;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.robot.RobotState;
import org.robonewbie.simulator.PitchDetails;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.physics.RotationMatrix;

/**
 * Converts the scene graph from a monitor port to world snapshots. The scene graph contains the pose of each limb but
 * no joint angles; these are computed from the relative rotation of the two limbs that a hinge connects.
 */
final class MonitorSnapshots {

    private static final int ROBOTS_PER_SIDE = 100;

    private MonitorSnapshots() {}

    static WorldSnapshot of(MonitoredWorld world, long cycle, double realTimeFactor, boolean standing) {
        MonitoredGame game = world.gameState();
        return new WorldSnapshot(
                cycle,
                game.timeSeconds(),
                game.playMode().orElse(PlayMode.PLAY_ON),
                team(game, TeamSide.LEFT),
                team(game, TeamSide.RIGHT),
                game.scoreLeft(),
                game.scoreRight(),
                game.half(),
                ball(world).position(),
                ball(world).rotation(),
                robots(world, game),
                world.rsmp().isPresent() ? List.of() : MonitoredThings.of(world),
                standing,
                1,
                realTimeFactor);
    }

    private static Pose ball(MonitoredWorld world) {
        return world.rsmp().isPresent()
                ? world.rsmp().get().ball().orElse(Pose.ORIGIN)
                : world.ball()
                        .map(ball -> new Pose(ball.position(), rotation(ball).toQuaternion()))
                        .orElse(Pose.ORIGIN);
    }

    private static List<RobotSnapshot> robots(MonitoredWorld world, MonitoredGame game) {
        return world.rsmp().isPresent()
                ? world.rsmp().get().robots().stream()
                        .map(robot -> snapshot(robot.player(), game, robot.state()))
                        .toList()
                : world.robots().stream().map(robot -> robot(robot, game)).toList();
    }

    /** Returns the dimensions of the pitch; values that the server does not send default to the league's. */
    static SoccerField field(MonitoredWorld world) {
        Environment environment = world.environment();
        if (world.rsmp().isPresent()) {
            return RsmpPitch.field(environment);
        }
        SoccerField league = SoccerField.LEAGUE;
        double goalWidth = environment.measure("GoalWidth").orElse(league.goalWidth());
        double areaWidth = environment.measure("GoalieAreaWidth").orElse(league.penaltyWidth() + league.goalWidth());
        double circle = environment.measure("FreeKickDistance").orElse(league.centreCircleRadius());
        return new SoccerField(
                environment.measure("FieldLength").orElse(league.length()),
                environment.measure("FieldWidth").orElse(league.width()),
                goalWidth,
                environment.measure("GoalDepth").orElse(league.goalDepth()),
                environment.measure("GoalHeight").orElse(league.goalHeight()),
                environment.measure("GoalieAreaLength").orElse(league.penaltyLength()),
                Math.max(0, areaWidth - goalWidth),
                environment.measure("CenterCircleRadius").orElse(circle));
    }

    /** Returns ball and markings of the pitch. */
    static PitchDetails details(MonitoredWorld world) {
        return world.rsmp().isPresent() ? RsmpPitch.details(world.environment()) : PitchDetails.SIMSPARK;
    }

    private static String team(MonitoredGame game, TeamSide side) {
        Optional<String> name = side == TeamSide.LEFT ? game.teamLeft() : game.teamRight();
        return name.orElse("");
    }

    private static RobotSnapshot robot(MonitoredRobot robot, MonitoredGame game) {
        NaoModel model = NaoModel.of(robot.type());
        BodyState body = BodyState.ofHinges(robot.type(), torso(robot), hingeDegrees(robot, model));
        return snapshot(robot.player(), game, new RobotState.OfNao(body));
    }

    private static RobotSnapshot snapshot(PlayerNumber player, MonitoredGame game, RobotState state) {
        TeamSide side = player.side();
        String name = team(game, side);
        return new RobotSnapshot(
                ROBOTS_PER_SIDE * side.ordinal() + player.number(),
                name.isEmpty() ? side.name().toLowerCase(Locale.ROOT) : name,
                Optional.of(side),
                player.number(),
                state);
    }

    private static Pose torso(MonitoredRobot robot) {
        return robot.link(NaoModel.TORSO)
                .map(part -> new BodyPose(part.position(), rotation(part)).toBodyAxes())
                .orElse(Pose.ORIGIN);
    }

    private static double[] hingeDegrees(MonitoredRobot robot, NaoModel model) {
        return model.hinges().stream()
                .mapToDouble(hinge -> robot.link(hinge.parent())
                        .flatMap(parent -> robot.link(hinge.child()).map(child -> degrees(hinge, parent, child)))
                        .orElse(0.0))
                .toArray();
    }

    /** Returns the hinge angle in degrees that best matches the child's rotation relative to its parent. */
    private static double degrees(Hinge hinge, TransformNode parent, TransformNode child) {
        Rotation turn = rotation(parent).inverse().after(rotation(child)).toQuaternion();
        Vector3 axis = hinge.axis();
        double sine = turn.x() * axis.x() + turn.y() * axis.y() + turn.z() * axis.z();
        return Math.toDegrees(2 * Math.atan2(sine, turn.w()));
    }

    static RotationMatrix rotation(TransformNode node) {
        Vector3 x = node.axisX();
        Vector3 y = node.axisY();
        Vector3 z = node.axisZ();
        return new RotationMatrix(x.x(), y.x(), z.x(), x.y(), y.y(), z.y(), x.z(), y.z(), z.z());
    }
}
