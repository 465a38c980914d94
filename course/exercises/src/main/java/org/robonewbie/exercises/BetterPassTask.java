package org.robonewbie.exercises;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/**
 * Task: pass to the teammate with a free passing lane, twice. An opponent first blocks the nearer teammate, then the farther
 * one; between the passes, all robots are moved back to their start poses. Once the ball has hit the opponent, its path no
 * longer counts, because a deflection to the free teammate would be luck.
 */
final class BetterPassTask implements Task {

    private static final Pose2d PASSER = new Pose2d(-1.5, 0, 0);
    private static final Vector3 BALL = new Vector3(-1.05, 0.05, 0);
    private static final int PASSES = 2;
    private static final double PASS_SECONDS = 25;
    private static final double OPPONENT_METRES = 0.8;
    private static final double REACHED_METRES = 0.8;
    private static final double STAYED_METRES = 0.9;
    private static final double STOPPED_METRES = 0.3;
    private static final int OPPONENT = 3;

    /** Start poses of the passer, both teammates and the opponent, for each of the two passes. */
    private final List<List<Pose2d>> starts = new ArrayList<>();

    private final double[] nearest = new double[PASSES];
    private int pass;
    private boolean stopped;
    private double strayed;

    /** Creates the task for one trial. */
    public BetterPassTask() {
        Arrays.fill(nearest, Double.POSITIVE_INFINITY);
    }

    @Override
    public Scene scene(RandomSource random) {
        int nearSide = random.isSeedOdd() ? 1 : -1;
        Pose2d near = mate(nearSide * random.between(38, 44), random.between(1.5, 1.6));
        Pose2d far = mate(-nearSide * random.between(38, 44), random.between(1.8, 1.9));
        starts.add(List.of(PASSER, near, far, before(near)));
        starts.add(List.of(PASSER, near, far, before(far)));
        return Scene.of(
                        RobotStart.at(PASSER).after("stand"),
                        RobotStart.at(near).after("stand").withTeam(RobotStart.TEAM, 2),
                        RobotStart.at(far).after("stand").withTeam(RobotStart.TEAM, 3),
                        RobotStart.at(before(near)).after("stand").withTeam("Others", 2))
                .withBall(BALL);
    }

    private static Pose2d mate(double degrees, double metres) {
        double angle = PortableMath.toRadians(degrees);
        return new Pose2d(
                BALL.x() + metres * PortableMath.cos(angle),
                BALL.y() + metres * PortableMath.sin(angle),
                180 + degrees);
    }

    /** Returns the pose of an opponent that blocks the passing lane to a teammate. */
    private static Pose2d before(Pose2d mate) {
        Vector3 way = mate.point(0, 0, 0).minus(BALL);
        Vector3 place = BALL.plus(way.times(OPPONENT_METRES / way.length()));
        return new Pose2d(place.x(), place.y(), mate.degrees());
    }

    @Override
    public void act(Trial trial) {
        if (pass == 0 && trial.seconds() >= PASS_SECONDS) {
            pass = 1;
            stopped = false;
            for (int i = 0; i < starts.get(1).size(); i++) {
                trial.moveRobot(i, starts.get(1).get(i));
            }
            trial.placeBall(BALL);
        }
    }

    @Override
    public void see(WorldState state) {
        List<Pose2d> places = starts.get(pass);
        for (int i = 0; i < places.size() && nearest[pass] > REACHED_METRES; i++) {
            strayed = Math.max(
                    strayed, places.get(i).distance(state.robots().get(i).position()));
        }
        stopped |= places.get(OPPONENT).distance(state.ball()) < STOPPED_METRES;
        if (!stopped) {
            Pose2d free = places.get(freeMate(pass));
            nearest[pass] = Math.min(nearest[pass], free.distance(state.ball()));
        }
    }

    /** Returns the index of the free teammate: the farther one in the first pass, the nearer one in the second. */
    private static int freeMate(int number) {
        return 2 - number;
    }

    @Override
    public boolean isDecided() {
        return strayed > STAYED_METRES || nearest[1] <= REACHED_METRES;
    }

    @Override
    public Score score() {
        String finding = String.format(
                Locale.ROOT,
                "first pass %s, second pass %s%s",
                describe(0),
                describe(1),
                strayed > STAYED_METRES ? ", and a player left its position" : "");
        if (strayed > STAYED_METRES) {
            return Score.failed(
                    1,
                    finding,
                    "All players must stay within 0.9 m of where they start: number 1 only gets"
                            + " behind the ball and stops after its kick, and its teammates wait.");
        }
        boolean first = nearest[0] <= REACHED_METRES;
        boolean second = nearest[1] <= REACHED_METRES;
        return first && second
                ? Score.passed(finding)
                : Score.failed(
                        first || second ? 3 : 0,
                        finding,
                        "For each teammate, compute how close an opponent is to the line from the ball"
                                + " to that teammate: use Translation2d.distanceToSegment. Kick.kick walks behind"
                                + " the ball automatically; keep giving it the same direction until the ball rolls.");
    }

    private String describe(int number) {
        return Double.isInfinite(nearest[number])
                ? "not tried"
                : String.format(Locale.ROOT, "at best %.2f m from the free teammate", nearest[number]);
    }
}
