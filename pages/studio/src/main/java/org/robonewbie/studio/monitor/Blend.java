package org.robonewbie.studio.monitor;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.robot.RobotState;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.landscape.Thing;

/** Linear interpolation between two states of the world. */
final class Blend {

    private static final double JUMP_METRES = 1;

    /** Larger changes of a joint angle are a jump from one end of its range to the other. */
    private static final double HALF_TURN = 180;

    private Blend() {}

    /**
     * Interpolates between two states.
     *
     * @param from the earlier state
     * @param to the later state
     * @param part interpolation parameter: 0 for the earlier, 1 for the later state
     */
    static WorldSnapshot of(WorldSnapshot from, WorldSnapshot to, double part) {
        return new WorldSnapshot(
                from.cycle() + Math.round(part * (to.cycle() - from.cycle())),
                from.gameTime() + part * (to.gameTime() - from.gameTime()),
                from.playMode(),
                from.teamLeft(),
                from.teamRight(),
                from.scoreLeft(),
                from.scoreRight(),
                from.half(),
                isJump(from, to)
                        ? from.ballPosition()
                        : from.ballPosition()
                                .plus(to.ballPosition()
                                        .minus(from.ballPosition())
                                        .times(part)),
                blended(from.ballRotation(), to.ballRotation(), part),
                robots(from.robots(), to.robots(), part),
                things(from.things(), to.things(), part),
                to.paused(),
                to.speed(),
                to.realTimeFactor());
    }

    private static boolean isJump(WorldSnapshot from, WorldSnapshot to) {
        return to.ballPosition().minus(from.ballPosition()).length() > 3 * JUMP_METRES;
    }

    private static List<RobotSnapshot> robots(List<RobotSnapshot> from, List<RobotSnapshot> to, double part) {
        List<RobotSnapshot> robots = new ArrayList<>();
        for (RobotSnapshot robot : from) {
            robots.add(to.stream()
                    .filter(each -> each.id() == robot.id() && isSameModel(each.state(), robot.state()))
                    .findFirst()
                    .map(later -> robot(robot, later, part))
                    .orElse(robot));
        }
        return robots;
    }

    private static List<Thing> things(List<Thing> from, List<Thing> to, double part) {
        List<Thing> things = new ArrayList<>();
        for (int i = 0; i < Math.min(from.size(), to.size()); i++) {
            Pose pose = from.get(i).pose();
            Pose later = to.get(i).pose();
            things.add(from.get(i).at(between(pose, later, step(pose, later, part))));
        }
        return things;
    }

    private static RobotSnapshot robot(RobotSnapshot from, RobotSnapshot to, double part) {
        Pose torso = from.state().torso();
        double step = step(torso, to.state().torso(), part);
        Pose between = between(torso, to.state().torso(), step);
        double[] degrees = blended(from.state(), to.state(), step);
        RobotState state = from.state() instanceof RobotState.OfNao nao
                ? new RobotState.OfNao(BodyState.ofHinges(nao.body().type(), between, degrees))
                : new RobotState.OfModel(from.state().model(), between, degrees);
        return new RobotSnapshot(from.id(), from.team(), from.side(), from.number(), state);
    }

    private static boolean isSameModel(RobotState one, RobotState other) {
        return one.model().equals(other.model());
    }

    private static double step(Pose from, Pose to, double part) {
        Vector3 way = to.position().minus(from.position());
        return Math.hypot(way.x(), way.y()) > JUMP_METRES ? 0 : part;
    }

    private static Pose between(Pose from, Pose to, double step) {
        Vector3 way = to.position().minus(from.position());
        return new Pose(from.position().plus(way.times(step)), blended(from.rotation(), to.rotation(), step));
    }

    /**
     * Interpolates quaternions linearly and normalises the result. The signs are aligned first, so that the rotation
     * takes the shorter path.
     */
    private static Rotation blended(Rotation from, Rotation to, double part) {
        double dot = from.w() * to.w() + from.x() * to.x() + from.y() * to.y() + from.z() * to.z();
        double sign = dot < 0 ? -1 : 1;
        double rest = 1 - part;
        double w = rest * from.w() + sign * part * to.w();
        double x = rest * from.x() + sign * part * to.x();
        double y = rest * from.y() + sign * part * to.y();
        double z = rest * from.z() + sign * part * to.z();
        double length = Math.sqrt(w * w + x * x + y * y + z * z);
        return new Rotation(w / length, x / length, y / length, z / length);
    }

    private static double[] blended(RobotState from, RobotState to, double part) {
        double[] between = new double[from.joints()];
        for (int i = 0; i < between.length; i++) {
            double change = to.degrees(i) - from.degrees(i);
            between[i] = from.degrees(i) + part * (Math.abs(change) > HALF_TURN ? 0 : change);
        }
        return between;
    }
}
