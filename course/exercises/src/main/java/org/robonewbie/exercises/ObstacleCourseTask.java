package org.robonewbie.exercises;

import java.util.List;
import java.util.Locale;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.landscape.Thing;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.WorldState;

/** Task: walk to the ball through two gates, each between a wall and a post, without touching them. */
final class ObstacleCourseTask implements Task {

    private static final double MOVED_METRES = 0.02;
    private static final double NEAR_METRES = 0.6;

    /** A gate between a wall and a post. */
    private record Gate(Thing wall, Thing post) {

        /** Returns whether the robot passed the gate in this cycle. */
        boolean isPassed(Pose2d before, Pose2d now) {
            double line = post.centre().x();
            double nearWall = wall.centre().y()
                    + Math.signum(post.centre().y() - wall.centre().y())
                            * wall.size().y()
                            / 2;
            double least = Math.min(nearWall, post.centre().y());
            double most = Math.max(nearWall, post.centre().y());
            return before.x() < line && now.x() >= line && now.y() > least && now.y() < most;
        }
    }

    private static final List<Thing> THINGS = Landscape.OBSTACLES.things();
    private static final List<Gate> GATES =
            List.of(new Gate(THINGS.get(0), THINGS.get(1)), new Gate(THINGS.get(2), THINGS.get(3)));

    private Pose2d before = new Pose2d(0, 0, 0);
    private int passed;
    private double moved;
    private double nearest = Double.POSITIVE_INFINITY;
    private double seconds;

    @Override
    public Scene scene(RandomSource random) {
        Pose2d start = new Pose2d(random.between(-4.9, -4.6), random.between(-1, 1), random.between(-30, 30));
        return Scene.of(RobotStart.at(start).after("stand"))
                .withLandscape(Landscape.OBSTACLES)
                .withBall(random.between(-0.6, 0.2), random.between(-1, 1));
    }

    @Override
    public void see(WorldState state) {
        seconds = state.seconds();
        Pose2d now = state.place();
        if (seconds > 0 && passed < GATES.size() && GATES.get(passed).isPassed(before, now)) {
            passed++;
        }
        before = now;
        for (int i = 0; i < THINGS.size(); i++) {
            Vector3 start = THINGS.get(i).centre();
            moved = Math.max(moved, state.things().get(i).centre().distanceTo(start));
        }
        nearest = Math.min(nearest, now.distance(state.ball()));
    }

    @Override
    public boolean isDecided() {
        return moved > MOVED_METRES || (passed == GATES.size() && nearest <= NEAR_METRES);
    }

    @Override
    public Score score() {
        String finding = String.format(
                Locale.ROOT,
                "%d of 2 gates, %.2f m from the ball at best, objects moved by %.2f m, %.0f s",
                passed,
                nearest,
                moved,
                seconds);
        if (moved > MOVED_METRES) {
            return Score.failed(
                    passed,
                    finding,
                    "Something was touched. Aim for the middle of a gate from 0.6 m in front of it, and look straight"
                            + " ahead while you walk through.");
        }
        if (passed < GATES.size()) {
            return Score.failed(
                    2.0 * passed,
                    finding,
                    "The first gate is between the wall and the post at x = -3.6 (y from -1.24 to"
                            + " -0.3), the second at x = -2.2 (y from 0.3 to 1.24). SelfLocalisation tells you"
                            + " where you are.");
        }
        return nearest <= NEAR_METRES
                ? Score.passed(finding)
                : Score.failed(6, finding, "After the second gate, look for the ball and walk to it.");
    }
}
