package org.robonewbie.examples;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.Options;
import org.robonewbie.agent.StartPose;
import org.robonewbie.agent.localisation.GroundPose;
import org.robonewbie.agent.localisation.SelfLocalisation;
import org.robonewbie.agent.perception.CameraTransformation;
import org.robonewbie.agent.perception.FieldItem;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;

/**
 * Keeps the goal against {@link Agent_PenaltyAttacker}: watches the ball, foresees where it will cross the goal line, and dives
 * if it comes fast. Afterwards it gets up and walks back to its place.
 *
 * <p>How fast the ball is, no sensor tells: it is calculated from two pictures of the camera. Ideas: come out of the goal to make
 * the angle smaller; do not dive if a step aside is enough.
 */
public final class Agent_PenaltyGoalkeeper extends Agent {

    private static final SoccerField FIELD = SoccerField.BEGINNER;
    private static final StartPose PLACE = new StartPose(-FIELD.length() / 2 + 0.25, 0, 0);
    private static final double FAST_METRES_PER_SECOND = 0.7;
    private static final double SOON_SECONDS = 1.5;
    private static final double REACH_METRES = 0.12;
    private static final double PICTURE_SECONDS = 0.3;

    private final SelfLocalisation self = new SelfLocalisation(FIELD);
    private boolean placed;
    private double pictureSeconds;
    private Vector3 ballBefore = Vector3.ZERO;
    private Vector3 ballVelocity = Vector3.ZERO;

    /** Creates the agent. */
    public Agent_PenaltyGoalkeeper() {
        fieldView.setTransformation(CameraTransformation.KINEMATICS);
    }

    /**
     * Starts the robot.
     *
     * @param args options such as {@code --headless}; {@code --help} lists them
     */
    public static void main(String[] args) {
        new Agent_PenaltyGoalkeeper().run(args);
    }

    @Override
    protected Options defaults() {
        return Options.none().withTeam("Keepers").withNumber(1).withPose(PLACE.x(), PLACE.y(), PLACE.degrees());
    }

    @Override
    protected void think() {
        if (!placed || (nao.isBeamAllowed() && self.pose().x() > PLACE.x() + 1)) {
            self.setPose(new GroundPose(PLACE.x(), PLACE.y(), PLACE.degrees()));
            placed = true;
        }
        self.update(nao, fieldView);
        FieldItem ball = fieldView.ball();
        if (ball.isVisible() && nao.getTime() - pictureSeconds >= PICTURE_SECONDS - 0.001) {
            measureVelocity(ball.position());
        }
        if (!motions.isFinished()) {
            return;
        }
        if (nao.isFallen()) {
            motions.startGetUp();
        } else if (ball.isVisible() && isShot(ball.position())) {
            double crossing = crossing(ball.position());
            if (Math.abs(crossing) > REACH_METRES) {
                log.info("ball crosses %.2f m left of me with %.1f m/s", crossing, ballVelocity.length());
                motions.start(crossing > 0 ? "dive-left" : "dive-right");
            }
        } else {
            returnToPlace(ball);
        }
    }

    private void measureVelocity(Vector3 ball) {
        double seconds = nao.getTime() - pictureSeconds;
        boolean usable = seconds < 2 * PICTURE_SECONDS && !walk.isWalking();
        ballVelocity = usable ? ball.minus(ballBefore).times(1 / seconds) : Vector3.ZERO;
        ballBefore = ball;
        pictureSeconds = nao.getTime();
    }

    /** Whether the ball comes so fast that the goal is in danger. */
    private boolean isShot(Vector3 ball) {
        double approach = -ballVelocity.x();
        return approach > FAST_METRES_PER_SECOND
                && ball.x() / approach < SOON_SECONDS
                && Math.abs(crossing(ball)) < FIELD.goalWidth() / 2 + 0.1;
    }

    /** How far to the left of the robot the ball will pass, in metres. */
    private double crossing(Vector3 ball) {
        return ball.y() + ballVelocity.y() * ball.x() / Math.max(0.01, -ballVelocity.x());
    }

    private void returnToPlace(FieldItem ball) {
        Vector3 way = self.pose().fromFrame(new Vector3(PLACE.x(), PLACE.y(), 0));
        double turn = -self.pose().headingDegrees();
        boolean atPlace = Math.hypot(way.x(), way.y()) < (walk.isWalking() ? 0.08 : 0.25);
        if (atPlace && Math.abs(turn) < (walk.isWalking() ? 5 : 15)) {
            walk.stop();
        } else {
            walk.towards(way.x(), way.y(), turn);
        }
        if (ball.ageSeconds() > 1) {
            lookAround.look();
        } else {
            nao.setJointAngle(Joint.NECK_YAW, Math.max(-80, Math.min(80, ball.bearing())), 180);
            nao.setJointAngle(Joint.NECK_PITCH, -15, 90);
        }
    }
}
