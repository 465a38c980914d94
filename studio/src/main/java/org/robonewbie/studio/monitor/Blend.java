package org.robonewbie.studio.monitor;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.WorldSnapshot;

/** A state between two known ones: everything moves evenly. */
final class Blend {

    private static final double JUMP_METRES = 1;

    private Blend() {}

    /**
     * Blends two states.
     *
     * @param from the earlier one
     * @param to the later one
     * @param part 0 for the earlier, 1 for the later
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
                    .filter(each -> each.id() == robot.id() && each.type() == robot.type())
                    .findFirst()
                    .map(later -> robot(robot, later, part))
                    .orElse(robot));
        }
        return robots;
    }

    private static RobotSnapshot robot(RobotSnapshot from, RobotSnapshot to, double part) {
        Pose torso = from.body().torso();
        Pose later = to.body().torso();
        Vector3 way = later.position().minus(torso.position());
        double step = Math.hypot(way.x(), way.y()) > JUMP_METRES ? 0 : part;
        Pose between =
                new Pose(torso.position().plus(way.times(step)), blended(torso.rotation(), later.rotation(), step));
        return new RobotSnapshot(
                from.id(),
                from.team(),
                from.side(),
                from.number(),
                BodyState.ofHinges(
                        from.type(),
                        between,
                        blended(from.body().hingeDegrees(), to.body().hingeDegrees(), step)));
    }

    /** The parts of quaternions are blended alike; a quaternion that points the other way is turned round first. */
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

    private static double[] blended(double[] from, double[] to, double part) {
        double[] between = new double[from.length];
        for (int i = 0; i < between.length; i++) {
            between[i] = from[i] + part * (to[i] - from[i]);
        }
        return between;
    }
}
