package org.robonewbie.exercises;

import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.WorldState;

/** Task: score a goal past a wall of three standing robots. The trial ends if one of them is pushed away. */
final class ScoreAGoalTask implements Task {

    private static final Pose2d STUDENT = new Pose2d(-0.5, 0.4, -40);
    private static final double GOAL_X = 6;
    private static final double PUSHED_METRES = 0.1;
    private static final double WALL_METRES = 0.45;
    private static final double QUICK_SECONDS = 45;
    private static final double SECONDS_PER_POINT = 20;

    /** Time in seconds without any movement after which the trial is stopped. */
    private static final double SECONDS_OF_PATIENCE = 30;

    private static final double STAYED_METRES = 0.1;

    private double seconds;
    private double nearest = Double.POSITIVE_INFINITY;
    private boolean scored;
    private Vector3 lastBall = Vector3.ZERO;
    private Vector3 lastTorso = Vector3.ZERO;
    private double lastMoved;
    private List<Pose2d> wall = List.of();
    private boolean pushed;

    @Override
    public Scene scene(RandomSource random) {
        double x = random.between(2.6, 3.2);
        double y = (random.isSeedOdd() ? 1 : -1) * random.between(0, 0.35);
        return Scene.of(
                        RobotStart.at(STUDENT),
                        defender(2, x, y - WALL_METRES),
                        defender(3, x, y),
                        defender(4, x, y + WALL_METRES))
                .withBall(0, 0);
    }

    private static RobotStart defender(int number, double x, double y) {
        return RobotStart.at(new Pose2d(x, y, 180)).withTeam("Others", number);
    }

    @Override
    public void see(WorldState state) {
        Vector3 ball = state.ball();
        nearest = Math.min(nearest, PortableMath.hypot(GOAL_X - ball.x(), ball.y()));
        scored |= state.goals(TeamSide.LEFT) > 0;
        seconds = state.seconds();
        wall = wall.isEmpty() ? wall(state) : wall;
        pushed |= IntStream.range(0, wall.size())
                .anyMatch(i -> wall.get(i).distance(state.robots().get(i + 1).position()) > PUSHED_METRES);
        Vector3 torso = state.robot().position();
        if (ball.distanceTo(lastBall) > STAYED_METRES || torso.distanceTo(lastTorso) > STAYED_METRES) {
            lastBall = ball;
            lastTorso = torso;
            lastMoved = seconds;
        }
    }

    private static List<Pose2d> wall(WorldState state) {
        return IntStream.range(1, state.robots().size()).mapToObj(state::place).toList();
    }

    @Override
    public boolean isDecided() {
        return scored || pushed || isStuck();
    }

    private boolean isStuck() {
        return seconds - lastMoved > SECONDS_OF_PATIENCE;
    }

    @Override
    public Score score() {
        if (pushed) {
            return Score.failed(
                    2,
                    String.format(Locale.ROOT, "a robot in the wall was pushed away after %.1f s", seconds),
                    "Go around the wall with the ball: choose a point beside the outermost robot, then the goal once"
                            + " the ball has passed it.");
        }
        if (!scored) {
            return Score.failed(
                    3 - nearest,
                    String.format(
                            Locale.ROOT,
                            "no goal%s; the ball came within %.2f m of the goal",
                            isStuck() ? ", and nothing moved for " + Math.round(SECONDS_OF_PATIENCE) + " s" : "",
                            nearest),
                    "Push the ball past the wall first: choose a point beside the outermost robot."
                            + " When the ball has passed it, choose the middle of the goal: (6, 0).");
        }
        return Score.passed(
                (int) Math.floor(10 - Math.max(0, Math.ceil((seconds - QUICK_SECONDS) / SECONDS_PER_POINT))),
                String.format(Locale.ROOT, "goal after %.1f s", seconds),
                seconds > QUICK_SECONDS ? "A goal within 45 s earns 10 points." : "");
    }
}
