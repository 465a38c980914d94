package org.robonewbie.learning.environment;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.robonewbie.agent.walk.SoccerPolicy;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/**
 * Self-play between two teams until the first goal. Robots walk and get up as agents do; an action is the velocity of the walk. A ball that
 * leaves the pitch beside the goal is put back, as after a goal kick that no robot takes.
 */
final class MatchTraining extends TrainingTask {

    private static final String[] TEAMS = {"left", "right"};
    private static final SoccerField FIELD = SoccerField.BEGINNER;
    private static final double GOAL_REWARD = 10;
    private static final double APPROACH_REWARD = 1;
    private static final double AHEAD_METRES = 0.2;
    private static final double FALL_PENALTY = 0.3;
    private static final double SPREAD_METRES = 0.3;
    private static final double SPREAD_DEGREES = 30;
    private static final double MAX_BACK_METRES = 4;
    private static final double ERROR_METRES = 0.2;
    private static final double ERROR_DEGREES = 5;
    private static final int CYCLES_OF_AN_ERROR = 50;
    private static final double MAX_X = FIELD.length() / 2 - 1.2;
    private static final double MAX_Y = FIELD.width() / 2 - 1;
    private static final double GOAL_KICK_Y = 2;

    private static final WorldState EMPTY =
            new WorldState(0, List.of(), Vector3.ZERO, Vector3.ZERO, List.of(), PlayMode.PLAY_ON, 0, 0);

    private final Scene scene;
    private final boolean startsAnywhere;
    private final int left;
    private WorldState now = EMPTY;
    private Pose2d error = Pose2d.ORIGIN;
    private int cycles;
    private int falls;
    private boolean lying;
    private double value;
    private int goal;

    private MatchTraining(Scene scene, boolean startsAnywhere) {
        this.scene = scene;
        this.startsAnywhere = startsAnywhere;
        left = (int) scene.robots().stream()
                .filter(robot -> robot.team().equals(TEAMS[0]))
                .count();
    }

    /** Creates a match between two teams with the given number of robots each. */
    static MatchTraining of(int robots) {
        List<RobotStart> all = new ArrayList<>();
        for (String team : TEAMS) {
            for (int i = 0; i < robots; i++) {
                all.add(start(team, i + 1, place(i)));
            }
        }
        return new MatchTraining(Scene.of(all.toArray(RobotStart[]::new)), true);
    }

    /** Creates a match between an attacker near the goal and the other team's goalkeeper, which defends it. */
    static MatchTraining keeperAgainstAttacker() {
        double goalLine = FIELD.length() / 2;
        return new MatchTraining(
                Scene.of(
                                start(TEAMS[0], 1, new Pose2d(goalLine - 2.8, 0, 0)),
                                start(TEAMS[1], 1, new Pose2d(-goalLine + 0.2, 0, 0)))
                        .withBall(goalLine - 2.5, 0),
                false);
    }

    /**
     * Returns the start pose of the robot with the given index. The first robot of a team stands near the ball; the others stand behind it
     * in rows of three.
     */
    private static Pose2d place(int index) {
        int row = (index + 2) / 3;
        int column = (index + 2) % 3;
        double y = row == 0 ? 0 : 2.0 * (column == 2 ? -1 : column);
        return new Pose2d(-0.8 - 1.2 * row, y, 0);
    }

    private static RobotStart start(String team, int number, Pose2d place) {
        boolean own = team.equals(TEAMS[0]);
        Pose2d there = own ? place : new Pose2d(-place.x(), -place.y(), 180);
        return RobotStart.at(there).withTeam(team, number).after(TO_THE_STANCE);
    }

    @Override
    public Scene scene(RandomSource random) {
        return scene;
    }

    @Override
    public int learners() {
        return scene.robots().size();
    }

    @Override
    public boolean steersWalk() {
        return true;
    }

    @Override
    public List<Joint> joints() {
        return List.of();
    }

    @Override
    public double rangeDegrees() {
        return 0;
    }

    @Override
    public int cyclesPerAction() {
        return 10;
    }

    @Override
    public int longestCycles() {
        return 2000;
    }

    /** Scatters ball and robots; both teams start equally far back. In half of the matches, the ball lies anywhere. */
    @Override
    public void begin(Trial trial) {
        if (startsAnywhere && random().between(0, 1) < 0.5) {
            trial.placeBall(new Vector3(random().between(-MAX_X, MAX_X), random().between(-MAX_Y, MAX_Y), 0));
        } else {
            scatterBall(trial, SPREAD_METRES);
        }
        WorldState first = trial.now();
        double space = IntStream.range(0, learners())
                .mapToDouble(i -> FIELD.length() / 2 - Math.abs(first.place(i).x()) - SPREAD_METRES)
                .min()
                .orElse(0);
        double back = Math.max(0, Math.min(MAX_BACK_METRES, space)) * random().between(0, 1);
        for (int i = 0; i < learners(); i++) {
            Vector3 torso = first.robots().get(i).position();
            Vector3 offset = new Vector3(
                    random().between(-SPREAD_METRES, SPREAD_METRES) + (i < left ? -back : back),
                    random().between(-SPREAD_METRES, SPREAD_METRES),
                    0);
            trial.robot(i).moveAndTurn(torso.plus(offset), random().between(-SPREAD_DEGREES, SPREAD_DEGREES));
        }
    }

    @Override
    public void act(Trial trial) {
        Vector3 ball = trial.ball().position();
        if (Math.abs(ball.x()) > FIELD.length() / 2 && !isGoal(ball)) {
            trial.placeBall(new Vector3(Math.copySign(MAX_X, ball.x()), Math.copySign(GOAL_KICK_Y, ball.y()), 0));
        } else if (Math.abs(ball.y()) > FIELD.width() / 2) {
            trial.placeBall(new Vector3(clamp(ball.x(), MAX_X), clamp(ball.y(), MAX_Y), 0));
        }
    }

    private static double clamp(double value, double max) {
        return Math.max(-max, Math.min(max, value));
    }

    private static boolean isGoal(Vector3 ball) {
        return Math.abs(ball.x()) > FIELD.length() / 2 && Math.abs(ball.y()) < FIELD.goalWidth() / 2;
    }

    /** Returns the distance from the ball to the point where it is to be: a little ahead of the robot. */
    private double distanceToBall(WorldState state) {
        return state.place(robot()).then(AHEAD_METRES, 0, 0).distance(state.ball());
    }

    /** Returns half of how much closer a point is to the right goal than to the left one. */
    private static double lead(Vector3 point) {
        double goalLine = FIELD.length() / 2;
        return (Math.hypot(point.x() + goalLine, point.y()) - Math.hypot(point.x() - goalLine, point.y())) / 2;
    }

    /** Returns 1 for the team that attacks the right goal, −1 for the other. */
    private int side() {
        return robot() < left ? 1 : -1;
    }

    @Override
    public List<ObservedQuantity> extraQuantities() {
        return ObservedQuantity.symmetric(SoccerPolicy.inputs(ownTeam() - 1, learners() - ownTeam()), 1);
    }

    private int ownTeam() {
        return side() > 0 ? left : learners() - left;
    }

    /**
     * {@return the positions that an agent knows: those of the ball and the other robots, and those of the goals from its localisation, with an
     * error that jumps}
     */
    @Override
    public double[] extras() {
        Pose2d own = now.place(robot());
        Pose2d believed = own.then(error.x(), error.y(), error.degrees());
        List<Vector3> all = new ArrayList<>();
        all.add(own.fromFrame(now.ball()));
        all.add(believed.fromFrame(new Vector3(side() * FIELD.length() / 2, 0, 0)));
        all.add(believed.fromFrame(new Vector3(-side() * FIELD.length() / 2, 0, 0)));
        others(true).forEach(mate -> all.add(own.fromFrame(mate)));
        others(false).forEach(opponent -> all.add(own.fromFrame(opponent)));
        return SoccerPolicy.values(now.robots().get(robot()).isFallen(), all);
    }

    private List<Vector3> others(boolean teammates) {
        return IntStream.range(0, learners())
                .filter(i -> i != robot() && (i < left == robot() < left) == teammates)
                .mapToObj(i -> now.robots().get(i).position())
                .toList();
    }

    @Override
    protected void see(WorldState first, WorldState current) {
        now = current;
        if (cycles++ % CYCLES_OF_AN_ERROR == 0) {
            error = new Pose2d(
                    random().between(-ERROR_METRES, ERROR_METRES),
                    random().between(-ERROR_METRES, ERROR_METRES),
                    random().between(-ERROR_DEGREES, ERROR_DEGREES));
        }
        boolean lies = now.robots().get(robot()).isFallen();
        falls += lies && !lying ? 1 : 0;
        lying = lies;
        if (isGoal(now.ball())) {
            goal = now.ball().x() > 0 ? 1 : -1;
        }
        double progress = lead(now.ball()) - lead(first.ball());
        double approach = distanceToBall(first) - distanceToBall(now);
        value = side() * (GOAL_REWARD * goal + progress) + APPROACH_REWARD * approach - FALL_PENALTY * falls;
    }

    /** {@return whether the robot's team has scored} */
    @Override
    public boolean isDone() {
        return goal == side();
    }

    /** {@return whether a goal has been scored; a fall does not end the match} */
    @Override
    public boolean isDecided() {
        return goal != 0;
    }

    @Override
    public String rewardRule() {
        return "10 for a goal and 1 per metre that the ball moves from goal to goal, both deducted from the other team; "
                + "1 per metre that the point 0.2 m ahead of the robot approaches the ball; each fall costs 0.3";
    }

    @Override
    public String successRule() {
        return "the team scores";
    }

    @Override
    public double value() {
        return value;
    }
}
