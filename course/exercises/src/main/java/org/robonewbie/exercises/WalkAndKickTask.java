package org.robonewbie.exercises;

import java.util.Locale;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.WorldState;

/** Task: walk to the ball and kick it. Walking into the ball does not make it fast enough. */
final class WalkAndKickTask implements Task {

    private static final Pose2d STUDENT = new Pose2d(-1.5, 0, 0);
    private static final Vector3 BALL = STUDENT.pointAt(1, 0.04);
    private static final double FAR_METRES = 1;
    private static final double KICKED_METRES_PER_SECOND = 2;
    private static final double RESTING_METRES_PER_SECOND = 0.1;
    private static final double TOUCHED_METRES = 0.1;

    private double metres;
    private double fastest;
    private double speed;

    @Override
    public Scene scene(RandomSource random) {
        return Scene.of(RobotStart.at(STUDENT).after("stand")).withBall(BALL).withoutNoise();
    }

    @Override
    public void see(WorldState state) {
        metres = Math.max(metres, BALL.distanceTo(state.ball()));
        speed = state.ballVelocity().length();
        fastest = Math.max(fastest, speed);
    }

    @Override
    public boolean isDecided() {
        return isKicked() && speed < RESTING_METRES_PER_SECOND;
    }

    private boolean isKicked() {
        return metres >= FAR_METRES && fastest >= KICKED_METRES_PER_SECOND;
    }

    @Override
    public Score score() {
        String finding = String.format(Locale.ROOT, "the ball rolled %.1f m", metres);
        if (isKicked()) {
            return Score.passed(finding);
        }
        return metres < TOUCHED_METRES
                ? Score.failed(0, finding, "The robot must reach the ball: start with walk.towards.")
                : Score.failed(
                        5,
                        finding,
                        "That was a push. Stop 0.3 m in front of the ball, then start the motion kick-left.");
    }
}
