package org.robonewbie.exercises;

import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/** Task: raise the arm on the side of another robot, which changes its position every three seconds. */
final class ArmBySideTask implements Task {

    private static final Pose2d STUDENT = new Pose2d(-3, 0, 0);
    private static final double PHASE_SECONDS = 3;
    private static final double JUDGED_FROM_SECONDS = 2;
    private static final double UP_DEGREES = 50;
    private static final double DOWN_DEGREES = 20;

    private List<Integer> sides = List.of(1, -1, 0, 1, -1, 0);
    private RandomSource places = new RandomSource(0);
    private final boolean[] wrong = new boolean[6];
    private int phase = -1;

    @Override
    public Scene scene(RandomSource random) {
        places = random;
        sides = random.shuffled(sides);
        return Scene.of(RobotStart.at(STUDENT), RobotStart.at(-5, 2).withTeam("Others", 2));
    }

    @Override
    public void act(Trial trial) {
        int now = phase(trial.seconds());
        if (now != phase) {
            phase = now;
            trial.moveRobot(1, dummyPlace(sides.get(phase)));
        }
    }

    private int phase(double seconds) {
        return Math.min(sides.size() - 1, (int) (seconds / PHASE_SECONDS));
    }

    @Override
    public void see(WorldState state) {
        int now = phase(state.seconds());
        if (state.seconds() - now * PHASE_SECONDS > JUDGED_FROM_SECONDS) {
            double left = state.robot().degrees(Joint.LEFT_SHOULDER_PITCH);
            double right = state.robot().degrees(Joint.RIGHT_SHOULDER_PITCH);
            wrong[now] |= isWrong(left, sides.get(now) > 0) || isWrong(right, sides.get(now) < 0);
        }
    }

    @Override
    public Score score() {
        int left = right(1);
        int right = right(-1);
        int none = right(0);
        String finding = String.format(
                Locale.ROOT,
                "correct %d of 2 times with the robot on the left, %d of 2 on the right, %d of 2 out of sight",
                left,
                right,
                none);
        int least = Math.min(left, Math.min(right, none));
        return least == 2
                ? Score.passed(finding)
                : Score.failed(
                        least == 0 ? (left + right + none) / 2.0 : 2.0 + left + right + none,
                        finding,
                        "fieldView.players() also lists robots that are out of sight: check isVisible(),"
                                + " and use the sign of bearing() to find the side. An arm counts as up above 50°"
                                + " and as down below 20°.");
    }

    /** Returns the number of phases in which the other robot was on the given side and the arms were correct. */
    private int right(int side) {
        return (int) IntStream.range(0, wrong.length)
                .filter(i -> sides.get(i) == side && !wrong[i])
                .count();
    }

    private static boolean isWrong(double degrees, boolean up) {
        return up ? degrees < UP_DEGREES : degrees > DOWN_DEGREES;
    }

    /** Returns a pose to the left of the student's robot, to its right, or behind it and out of view. */
    private Pose2d dummyPlace(int side) {
        double distance = places.between(1.2, 2.2);
        double bearing = side == 0 ? places.between(150, 210) : side * places.between(15, 40);
        Vector3 point = STUDENT.point(distance, bearing, 0);
        return new Pose2d(point.x(), point.y(), 180);
    }
}
