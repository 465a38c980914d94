package org.robonewbie.exercises.solution;

import java.util.HashMap;
import java.util.Map;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.localisation.SelfLocalisation;
import org.robonewbie.agent.perception.CameraTransformation;
import org.robonewbie.agent.perception.FieldItem;
import org.robonewbie.agent.perception.PlayerItem;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;

/** Knows where it is, walks behind the ball, and through it towards the goal. */
public final class ScoreAGoal extends Agent {

    /** Creates the solution. */
    public ScoreAGoal() {}

    private static final SoccerField FIELD = SoccerField.BEGINNER;

    private final SelfLocalisation self = new SelfLocalisation(FIELD);
    private static final double CLEAR_METRES = 1;

    private final Map<Integer, Vector3> wall = new HashMap<>();
    private boolean placed;
    private boolean passing;
    private boolean goLeft = true;

    @Override
    protected void think() {
        fieldView.setTransformation(CameraTransformation.KINEMATICS);
        if (!placed) {
            self.setPose(new Pose2d(-0.5, 0.4, -40));
            placed = true;
        }
        self.update(nao, fieldView);
        if (nao.isFallen()) {
            motions.startGetUp();
        } else if (motions.isFinished()) {
            play();
        }
    }

    private void play() {
        FieldItem ball = fieldView.ball();
        if (ball.ageSeconds() > 2) {
            lookAround.look();
            walk.towards(0, 0, 40);
            return;
        }
        Vector3 now = self.odometry().positionNow(ball);
        double bearing = Math.toDegrees(Math.atan2(now.y(), now.x()));
        nao.setJointAngle(Joint.NECK_YAW, Math.max(-80, Math.min(80, bearing)), 180);
        nao.setJointAngle(Joint.NECK_PITCH, -20, 90);
        remember();
        bring(now, self.pose().fromFrame(aim(self.pose().toFrame(now))));
    }

    /** Keeps where the opponents stand on the pitch. */
    private void remember() {
        for (PlayerItem opponent : fieldView.opponents()) {
            if (opponent.isVisible() && opponent.distance() < 3.5) {
                wall.put(opponent.number(), self.pose().toFrame(opponent.position()));
            }
        }
    }

    /** Beside the outermost opponent while the ball is before the wall, then the goal. */
    private Vector3 aim(Vector3 ball) {
        double left = wall.values().stream().mapToDouble(Vector3::y).max().orElse(0) + CLEAR_METRES;
        double right = wall.values().stream().mapToDouble(Vector3::y).min().orElse(0) - CLEAR_METRES;
        double x = wall.values().stream().mapToDouble(Vector3::x).max().orElse(-FIELD.length());
        if (ball.x() > x - (passing ? -0.2 : 0.2)) {
            passing = false;
            return new Vector3(FIELD.length() / 2 + 0.2, 0, 0);
        }
        passing = true;
        goLeft = goLeft
                ? Math.abs(left - ball.y()) < Math.abs(right - ball.y()) + 0.5
                : Math.abs(left - ball.y()) + 0.5 < Math.abs(right - ball.y());
        double y = goLeft ? left : right;
        boolean beside = goLeft ? ball.y() > left - 0.25 : ball.y() < right + 0.25;
        return new Vector3(beside ? x + 1 : x, y, 0);
    }

    private void bring(Vector3 ball, Vector3 goal) {
        Vector3 way = new Vector3(goal.x() - ball.x(), goal.y() - ball.y(), 0);
        Vector3 ahead = way.times(1 / Math.max(0.01, way.length()));
        Vector3 aside = new Vector3(-ahead.y(), ahead.x(), 0);
        double behind = ball.x() * ahead.x() + ball.y() * ahead.y();
        double left = -(ball.x() * aside.x() + ball.y() * aside.y());
        double turn = Math.toDegrees(Math.atan2(ahead.y(), ahead.x()));
        if (behind < 0.1) {
            walkTo(ball.minus(ahead.times(0.25)).plus(aside.times(left >= 0 ? 0.35 : -0.35)), turn);
        } else if (Math.abs(left) > 0.08 + 0.2 * Math.max(0, behind - 0.25) || Math.abs(turn) > 25) {
            walkTo(ball.minus(ahead.times(0.25)), turn);
        } else {
            walk.towards(0.6, -2 * left, 2 * turn);
        }
    }

    private void walkTo(Vector3 place, double turn) {
        double bearing = Math.toDegrees(Math.atan2(place.y(), place.x()));
        if (Math.hypot(place.x(), place.y()) > 0.7) {
            walk.towards(Math.abs(bearing) < 40 ? 0.6 : 0, 0, 1.5 * bearing);
        } else {
            walk.towards(1.5 * place.x(), 1.5 * place.y(), 1.5 * turn);
        }
    }
}
