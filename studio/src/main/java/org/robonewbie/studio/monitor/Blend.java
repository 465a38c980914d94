package org.robonewbie.studio.monitor;

import java.util.ArrayList;
import java.util.List;
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
                blended(from.ballOrientation(), to.ballOrientation(), part),
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
        double way = Math.hypot(to.linkPoses()[0] - from.linkPoses()[0], to.linkPoses()[1] - from.linkPoses()[1]);
        double step = way > JUMP_METRES ? 0 : part;
        return new RobotSnapshot(
                from.id(),
                from.team(),
                from.side(),
                from.number(),
                from.type(),
                blendedPoses(from.linkPoses(), to.linkPoses(), step),
                blended(from.jointDegrees(), to.jointDegrees(), step));
    }

    /** Positions and quaternions are blended alike; a quaternion that points the other way is turned round first. */
    private static float[] blendedPoses(float[] from, float[] to, double part) {
        float[] turned = to.clone();
        for (int at = 3; at < to.length; at += 7) {
            double dot = from[at] * to[at]
                    + from[at + 1] * to[at + 1]
                    + from[at + 2] * to[at + 2]
                    + from[at + 3] * to[at + 3];
            for (int i = at; i < at + 4 && dot < 0; i++) {
                turned[i] = -to[i];
            }
        }
        return blended(from, turned, part);
    }

    private static float[] blended(float[] from, float[] to, double part) {
        float[] between = new float[from.length];
        for (int i = 0; i < between.length; i++) {
            between[i] = (float) (from[i] + part * (to[i] - from[i]));
        }
        return between;
    }
}
