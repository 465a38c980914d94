package org.robonewbie.studio.monitor;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.Hinge;
import org.robonewbie.nao.model.Link;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.protocol.monitor.Environment;
import org.robonewbie.protocol.monitor.MonitoredGame;
import org.robonewbie.protocol.monitor.MonitoredRobot;
import org.robonewbie.protocol.monitor.MonitoredWorld;
import org.robonewbie.protocol.monitor.TransformNode;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.physics.Rotation;

/**
 * Turns what a monitor is told into states of our world. A monitor knows where each limb is, but no joint angles; they follow from
 * how the two limbs of a hinge are turned against each other.
 */
final class MonitorSnapshots {

    private static final int NUMBERS_PER_LINK = 7;
    private static final int ROBOTS_PER_SIDE = 100;
    private static final float[] UPRIGHT = {1, 0, 0, 0};

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
                world.ball().map(TransformNode::position).orElse(Vector3.ZERO),
                world.ball().map(MonitorSnapshots::quaternion).orElse(UPRIGHT),
                world.robots().stream().map(robot -> robot(robot, game)).toList(),
                standing,
                1,
                realTimeFactor);
    }

    /** Reads the measures of the pitch; what the server does not tell is as in the league. */
    static SoccerField field(Environment environment) {
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

    private static String team(MonitoredGame game, TeamSide side) {
        Optional<String> name = side == TeamSide.LEFT ? game.teamLeft() : game.teamRight();
        return name.orElse("");
    }

    private static RobotSnapshot robot(MonitoredRobot robot, MonitoredGame game) {
        TeamSide side = robot.player().side();
        NaoModel model = NaoModel.of(robot.type());
        String name = team(game, side);
        return new RobotSnapshot(
                ROBOTS_PER_SIDE * side.ordinal() + robot.player().number(),
                name.isEmpty() ? side.name().toLowerCase(Locale.ROOT) : name,
                Optional.of(side),
                robot.player().number(),
                robot.type(),
                linkPoses(robot, model),
                jointDegrees(robot, model));
    }

    /** A part that this server's robots do not have is where the torso is. */
    private static float[] linkPoses(MonitoredRobot robot, NaoModel model) {
        List<Link> links = model.links();
        float[] poses = new float[NUMBERS_PER_LINK * links.size()];
        Optional<TransformNode> torso = robot.link(NaoModel.TORSO);
        for (int i = 0; i < links.size(); i++) {
            Optional<TransformNode> part = robot.link(links.get(i).name()).or(() -> torso);
            Vector3 position = part.map(TransformNode::position).orElse(Vector3.ZERO);
            int at = NUMBERS_PER_LINK * i;
            poses[at] = (float) position.x();
            poses[at + 1] = (float) position.y();
            poses[at + 2] = (float) position.z();
            System.arraycopy(part.map(MonitorSnapshots::quaternion).orElse(UPRIGHT), 0, poses, at + 3, UPRIGHT.length);
        }
        return poses;
    }

    private static float[] jointDegrees(MonitoredRobot robot, NaoModel model) {
        List<Float> degrees = new ArrayList<>();
        for (Hinge hinge : model.hinges()) {
            degrees.add((float) robot.link(hinge.parent())
                    .flatMap(parent -> robot.link(hinge.child()).map(child -> degrees(hinge, parent, child)))
                    .orElse(0.0)
                    .doubleValue());
        }
        float[] numbers = new float[degrees.size()];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = degrees.get(i);
        }
        return numbers;
    }

    /** Finds the turn about the hinge's axis that is nearest to how the child is turned against its parent. */
    private static double degrees(Hinge hinge, TransformNode parent, TransformNode child) {
        double[] turn = rotation(parent).inverse().after(rotation(child)).toQuaternion();
        Vector3 axis = hinge.axis();
        double sine = turn[1] * axis.x() + turn[2] * axis.y() + turn[3] * axis.z();
        return Math.toDegrees(2 * Math.atan2(sine, turn[0]));
    }

    private static float[] quaternion(TransformNode node) {
        double[] exact = rotation(node).toQuaternion();
        return new float[] {(float) exact[0], (float) exact[1], (float) exact[2], (float) exact[3]};
    }

    private static Rotation rotation(TransformNode node) {
        Vector3 x = node.axisX();
        Vector3 y = node.axisY();
        Vector3 z = node.axisZ();
        return new Rotation(x.x(), y.x(), z.x(), x.y(), y.y(), z.y(), x.z(), y.z(), z.z());
    }
}
