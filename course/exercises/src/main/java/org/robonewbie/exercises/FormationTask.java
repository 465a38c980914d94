package org.robonewbie.exercises;

import java.util.Arrays;
import java.util.Locale;
import java.util.function.Predicate;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/**
 * Task: position three players around a ball without touching it: one at the ball, one between the ball and the team's own
 * goal, and one open for a pass. The ball is moved halfway through the trial.
 */
final class FormationTask implements Task {

    private static final int SCENES = 2;
    private static final double SCENE_SECONDS = 24;
    private static final double JUDGED_SECONDS = 2;
    private static final double OPPONENT_METRES = 1.2;
    private static final double AT_BALL_METRES = 0.9;
    private static final double COVER_ASIDE_METRES = 0.6;
    private static final double COVER_LEAST_METRES = 1.2;
    private static final double COVER_MOST_METRES = 3.5;
    private static final double PASS_LEAST_METRES = 1.8;
    private static final double PASS_MOST_METRES = 4;
    private static final double LANE_METRES = 0.7;
    private static final double TOUCHED_METRES = 0.1;
    private static final int PLAYERS = 3;
    private static final Vector3 OUR_GOAL = new Vector3(-6, 0, 0);
    private static final Vector3 THEIR_GOAL = new Vector3(6, 0, 0);

    private final Vector3[] balls = new Vector3[SCENES];
    private final boolean[][] missed = new boolean[SCENES][PLAYERS];
    private int scene;
    private boolean touched;
    private double seconds;

    /** Creates the task for one trial. */
    public FormationTask() {
        Arrays.fill(balls, Vector3.ZERO);
    }

    @Override
    public Scene scene(RandomSource random) {
        int side = random.isSeedOdd() ? 1 : -1;
        balls[0] = new Vector3(random.between(-0.8, -0.3), side * random.between(0.9, 1.3), 0);
        balls[1] = new Vector3(random.between(0.9, 1.3), -side * random.between(1.2, 1.6), 0);
        return Scene.of(
                        player(1, -4, random.between(-0.3, 0.3)),
                        player(2, -3.5, random.between(1.4, 1.8)),
                        player(3, -3.5, -random.between(1.4, 1.8)),
                        RobotStart.at(opponent(balls[0])).after("stand").withTeam("Others", 2))
                .withBall(balls[0]);
    }

    private static RobotStart player(int number, double x, double y) {
        return RobotStart.at(new Pose2d(x, y, 0)).after("stand").withTeam(RobotStart.TEAM, number);
    }

    /** Returns the pose of an opponent between the ball and the opponents' goal. */
    private static Pose2d opponent(Vector3 ball) {
        Vector3 way = THEIR_GOAL.minus(ball);
        Vector3 place = ball.plus(way.times(OPPONENT_METRES / way.length()));
        return new Pose2d(place.x(), place.y(), 180);
    }

    @Override
    public void act(Trial trial) {
        if (scene == 0 && trial.seconds() >= SCENE_SECONDS) {
            scene = 1;
            trial.moveRobot(PLAYERS, opponent(balls[1]));
            trial.placeBall(balls[1]);
        }
    }

    @Override
    public void see(WorldState state) {
        seconds = state.seconds();
        Vector3 ball = balls[scene];
        boolean settled = seconds - scene * SCENE_SECONDS > 0.5;
        touched |= settled && level(state.ball()).distanceTo(ball) > TOUCHED_METRES;
        if (seconds > (scene + 1) * SCENE_SECONDS - JUDGED_SECONDS) {
            Vector3 opponent = level(state.robots().get(PLAYERS).position());
            missed[scene][0] |= nobody(state, place -> place.distanceTo(ball) <= AT_BALL_METRES);
            missed[scene][1] |= nobody(state, place -> isCovering(place, ball));
            missed[scene][2] |= nobody(state, place -> isFree(place, ball, opponent));
        }
    }

    private static boolean nobody(WorldState state, Predicate<Vector3> question) {
        return state.robots().stream()
                .limit(PLAYERS)
                .map(BodyState::position)
                .map(FormationTask::level)
                .noneMatch(question);
    }

    private static boolean isCovering(Vector3 place, Vector3 ball) {
        double metres = place.distanceTo(ball);
        return metres >= COVER_LEAST_METRES
                && metres <= COVER_MOST_METRES
                && distanceToSegment(place, ball, OUR_GOAL) <= COVER_ASIDE_METRES;
    }

    private static boolean isFree(Vector3 place, Vector3 ball, Vector3 opponent) {
        double metres = place.distanceTo(ball);
        return metres >= PASS_LEAST_METRES
                && metres <= PASS_MOST_METRES
                && place.x() >= ball.x()
                && distanceToSegment(opponent, ball, place) >= LANE_METRES;
    }

    private static double distanceToSegment(Vector3 point, Vector3 from, Vector3 to) {
        Vector3 way = to.minus(from);
        double share = point.minus(from).dot(way) / way.dot(way);
        return point.distanceTo(from.plus(way.times(Math.max(0, Math.min(1, share)))));
    }

    private static Vector3 level(Vector3 point) {
        return new Vector3(point.x(), point.y(), 0);
    }

    @Override
    public boolean isDecided() {
        return touched;
    }

    @Override
    public Score score() {
        if (touched) {
            return Score.failed(
                    0,
                    String.format(Locale.ROOT, "the ball was touched after %.0f s", seconds),
                    "No player may touch the ball: the one that walks to the ball stops 0.6 m short of it.");
        }
        int right = 0;
        for (boolean[] each : missed) {
            for (boolean one : each) {
                right += one ? 0 : 1;
            }
        }
        String finding = String.format(Locale.ROOT, "first ball: %s, second ball: %s", describe(0), describe(1));
        return right == SCENES * PLAYERS
                ? Score.passed(finding)
                : Score.failed(
                        right - 2,
                        finding,
                        "Three positions depend on the ball: 0.6 m behind it, on the line to your goal,"
                                + " and further ahead beside the opponent. Which player takes which?"
                                + " Assignment.cheapest finds the shortest paths, and all players get the same"
                                + " result.");
    }

    private String describe(int number) {
        boolean[] bad = missed[number];
        return String.format(
                Locale.ROOT,
                "%s at the ball and %s in front of the goal and %s open for a pass",
                bad[0] ? "nobody" : "one",
                bad[1] ? "nobody" : "one",
                bad[2] ? "nobody" : "one");
    }
}
