package org.robonewbie.exercises;

import java.util.Locale;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/**
 * Task: save two shots, one on each side, that a stationary robot would not stop. Between the shots, the robot is moved
 * back to the middle of its goal.
 */
final class GoalkeeperTask implements Task {

    private static final Pose2d KEEPER = new Pose2d(-5.75, 0, 0);
    private static final double METRES_PER_SECOND = 6.6;
    private static final double SECOND_SCENE_SECONDS = 16;
    private static final double FLIGHT_SECONDS = 6;
    private static final double BEHIND_LINE = -6.05;
    private static final double HALF_GOAL = SoccerField.BEGINNER.goalWidth() / 2;

    private final double[] aims = new double[2];
    private final double[] shotSeconds = new double[2];
    private final double[] aside = new double[2];
    private int shots;
    private boolean carriedBack;
    private double seconds;
    private boolean goal;

    @Override
    public Scene scene(RandomSource random) {
        int side = random.isSeedOdd() ? 1 : -1;
        for (int i = 0; i < 2; i++) {
            aside[i] = random.between(-0.5, 0.5);
            aims[i] = (i == 0 ? side : -side) * random.between(0.27, 0.35);
            shotSeconds[i] = i * SECOND_SCENE_SECONDS + random.between(2, 3.5);
        }
        return Scene.of(RobotStart.at(KEEPER).after("stand")).withBall(-1.75, aside[0]);
    }

    @Override
    public void act(Trial trial) {
        if (!carriedBack && trial.seconds() >= SECOND_SCENE_SECONDS) {
            carriedBack = true;
            trial.moveRobot(0, KEEPER);
            trial.placeBall(new Vector3(-1.75, aside[1], 0));
        }
        if (shots < 2 && trial.seconds() >= shotSeconds[shots]) {
            Vector3 way =
                    new Vector3(KEEPER.x(), aims[shots], 0).minus(trial.ball().position());
            Vector3 level = new Vector3(way.x(), way.y(), 0);
            trial.ball().setVelocity(level.times(METRES_PER_SECOND / level.length()));
            shots++;
        }
    }

    @Override
    public void see(WorldState state) {
        seconds = state.seconds();
        Vector3 ball = state.ball();
        goal |= state.goals(TeamSide.RIGHT) > 0 || (ball.x() < BEHIND_LINE && Math.abs(ball.y()) < HALF_GOAL);
    }

    @Override
    public boolean isDecided() {
        return goal || (shots == 2 && seconds > shotSeconds[1] + FLIGHT_SECONDS);
    }

    @Override
    public Score score() {
        String last = side(Math.max(0, shots - 1));
        if (!goal) {
            return Score.passed(
                    String.format(Locale.ROOT, "saved the shots %s and %s of the middle", side(0), side(1)));
        }
        return Score.failed(
                shots == 2 ? 4 : 0,
                shots == 2 ? "saved the first shot; conceded the second, " + last : "conceded the first shot, " + last,
                shots == 2
                        ? "Get up after a dive and be ready again: the next shot goes to the other side."
                        : "From two camera images of the ball you can compute its velocity, and so where it will"
                                + " pass. To dive, play the motion \"dive-left\" or \"dive-right\".");
    }

    private String side(int shot) {
        return String.format(Locale.ROOT, "%.2f m to the %s", Math.abs(aims[shot]), aims[shot] > 0 ? "left" : "right");
    }
}
