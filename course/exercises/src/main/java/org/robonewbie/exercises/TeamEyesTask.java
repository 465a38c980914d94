package org.robonewbie.exercises;

import java.util.Locale;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/**
 * Task: the ball is behind robot 1, which may not look around. Robot 2 reports the side of the ball, and robot 1 raises
 * the arm on that side.
 */
final class TeamEyesTask implements Task {

    private static final Pose2d BLIND = new Pose2d(-1, 0, 0);
    private static final Pose2d SEEING = new Pose2d(1, 0, 180);
    private static final double PHASE_SECONDS = 6;
    private static final double JUDGED_FROM_SECONDS = 3.5;
    private static final double UP_DEGREES = 50;
    private static final double DOWN_DEGREES = 20;
    private static final double STILL_DEGREES = 25;
    private static final int PHASES = 4;

    private final boolean[] wrong = new boolean[PHASES];
    private final double[] places = new double[PHASES];
    private int firstSide = 1;
    private int phase = -1;
    private boolean looked;

    @Override
    public Scene scene(RandomSource random) {
        firstSide = random.side() > 0 ? 1 : -1;
        for (int i = 0; i < PHASES; i++) {
            places[i] = random.between(0.4, 0.9);
        }
        return Scene.of(
                        RobotStart.at(BLIND).after("stand"),
                        RobotStart.at(SEEING).after("stand").withTeam(RobotStart.TEAM, 2))
                .withBall(BLIND.pointAt(-1, firstSide * places[0]));
    }

    @Override
    public void act(Trial trial) {
        int now = phase(trial.seconds());
        if (now != phase) {
            phase = now;
            trial.placeBall(BLIND.pointAt(-1, side(now) * places[now]));
        }
    }

    /**
     * Returns the side of the ball in a phase. The order of the sides is A, B, B, A, so alternating the arms blindly
     * fails.
     */
    private int side(int number) {
        return number == 0 || number == PHASES - 1 ? firstSide : -firstSide;
    }

    private static int phase(double seconds) {
        return Math.min(PHASES - 1, (int) (seconds / PHASE_SECONDS));
    }

    @Override
    public void see(WorldState state) {
        BodyState blind = state.robot();
        looked |= Math.abs(blind.headingDegrees()) > STILL_DEGREES
                || Math.abs(blind.degrees(Joint.NECK_YAW)) > STILL_DEGREES;
        int now = phase(state.seconds());
        if (state.seconds() - now * PHASE_SECONDS > JUDGED_FROM_SECONDS) {
            boolean left = side(now) > 0;
            wrong[now] |= isWrong(blind.degrees(Joint.LEFT_SHOULDER_PITCH), left)
                    || isWrong(blind.degrees(Joint.RIGHT_SHOULDER_PITCH), !left);
        }
    }

    private static boolean isWrong(double degrees, boolean up) {
        return up ? degrees < UP_DEGREES : degrees > DOWN_DEGREES;
    }

    @Override
    public Score score() {
        int right = 0;
        for (boolean each : wrong) {
            right += each ? 0 : 1;
        }
        String finding = String.format(
                Locale.ROOT,
                "correct %d of %d times%s",
                right,
                PHASES,
                looked ? ", but number 1 turned or looked around" : "");
        if (right == PHASES && !looked) {
            return Score.passed(finding);
        }
        return Score.failed(
                looked ? 0 : Math.max(0, 2 * (right - 2)),
                finding,
                "Number 2 says what it sees: nao.say(\"left\"). Number 1 reads nao.getHeard(). They stand face to"
                        + " face: what is left for one is right for the other. An arm counts as up above 50° and as"
                        + " down below 20°.");
    }
}
