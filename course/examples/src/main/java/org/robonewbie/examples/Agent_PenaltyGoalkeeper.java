package org.robonewbie.examples;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.Options;
import org.robonewbie.agent.localisation.SelfLocalisation;
import org.robonewbie.agent.perception.CameraTransformation;
import org.robonewbie.agent.perception.FieldItem;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;

/**
 * A goalkeeper that plays against {@link Agent_PenaltyAttacker}: it watches the ball, predicts where it will cross the goal
 * line, and dives if the ball is fast. Afterwards it gets up and walks back to its position.
 *
 * <p>No sensor measures the ball's velocity: it is computed from two camera images. Ideas: come out of the goal to narrow the
 * angle; do not dive if a side step is enough.
 */
public final class Agent_PenaltyGoalkeeper extends Agent {

    private static final double BEFORE_LINE_METRES = 0.25;
    private static final double FAST_METRES_PER_SECOND = 0.7;
    private static final double ROLLING_SECONDS = 0.67;
    private static final double REACH_METRES = 0.12;
    private static final double PICTURE_SECONDS = 0.12;
    private static final int CERTAIN_PICTURES = 2;
    private static final double MEMORY_SECONDS = 1;

    private final SelfLocalisation self = new SelfLocalisation();
    private boolean placed;
    private double pictureSeconds;
    private int shotPictures;
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
        Pose2d place = place();
        return Options.none().withTeam("Keepers").withNumber(1).withPose(place.x(), place.y(), place.degrees());
    }

    @Override
    protected void think() {
        self.update(nao, fieldView);
        if (!placed || isElsewhere()) {
            goToPlace();
        }
        FieldItem ball = fieldView.ball();
        if (ball.isVisible() && nao.getTime() - pictureSeconds >= PICTURE_SECONDS - 0.001) {
            measure(ball.position());
        }
        if (nao.isFallen() && motions.isFinished()) {
            motions.startGetUp();
        } else if (motions.isFinished()) {
            keep(ball);
        }
    }

    private void keep(FieldItem ball) {
        if (shotPictures < CERTAIN_PICTURES || Math.abs(crossing(ball)) < REACH_METRES) {
            returnToPlace(ball);
        } else {
            double crossing = crossing(ball);
            log.info("ball crosses %.2f m left of me at %.1f m/s", crossing, ballVelocity.length());
            motions.start(crossing > 0 ? "dive-left" : "dive-right");
            shotPictures = 0;
        }
    }

    private void measure(Vector3 ball) {
        double seconds = nao.getTime() - pictureSeconds;
        boolean usable = seconds < 2 * PICTURE_SECONDS && !walk.isWalking() && motions.isFinished();
        ballVelocity = usable ? ball.minus(ballBefore).times(1 / seconds) : Vector3.ZERO;
        ballBefore = ball;
        pictureSeconds = nao.getTime();
        shotPictures = isShot(ball) ? shotPictures + 1 : 0;
    }

    /**
     * Returns whether the ball is fast enough to reach the goal. Friction stops the ball after 0.67 m for each m/s of its
     * speed.
     */
    private boolean isShot(Vector3 ball) {
        double approach = -ballVelocity.x();
        return approach > FAST_METRES_PER_SECOND
                && approach * ROLLING_SECONDS > ball.x()
                && Math.abs(crossing(fieldView.ball())) < self.field().goalWidth() / 2 + 0.1;
    }

    /** Returns the lateral distance at which the ball will pass the robot, in metres to the left. */
    private double crossing(FieldItem item) {
        Vector3 ball = item.position();
        return ball.y() + ballVelocity.y() * ball.x() / Math.max(0.01, -ballVelocity.x());
    }

    /** Returns the position one step in front of the centre of the team's own goal. */
    private Pose2d place() {
        return new Pose2d(BEFORE_LINE_METRES - self.field().length() / 2, 0, 0);
    }

    /**
     * Returns the lateral position at which the robot is on the line from the ball to the centre of the goal, in metres to the
     * left.
     */
    private double coveringY(FieldItem ball) {
        if (ball.ageSeconds() > MEMORY_SECONDS) {
            return 0;
        }
        Vector3 seen = self.pose().toFrame(ball.position());
        double ballBeforeLine =
                Math.max(2 * BEFORE_LINE_METRES, seen.x() + self.field().length() / 2);
        return seen.y() * BEFORE_LINE_METRES / ballBeforeLine;
    }

    private boolean isElsewhere() {
        return nao.isBeamAllowed() && Math.abs(self.pose().x() - place().x()) > 1;
    }

    private void goToPlace() {
        Pose2d place = place();
        if (placed) {
            nao.beam(place.x(), place.y(), place.degrees());
            motions.reset();
            motions.start("stand");
        }
        self.setPose(place);
        placed = true;
    }

    private void returnToPlace(FieldItem ball) {
        Vector3 way = self.pose().fromFrame(new Vector3(place().x(), coveringY(ball), 0));
        double turn = -self.pose().degrees();
        boolean atPlace = Math.hypot(way.x(), way.y()) < (walk.isWalking() ? 0.05 : 0.15);
        if (atPlace && Math.abs(turn) < (walk.isWalking() ? 5 : 15)) {
            walk.stop();
        } else {
            walk.towards(way.x(), way.y(), turn);
        }
        if (ball.ageSeconds() > MEMORY_SECONDS) {
            lookAround.look();
        } else {
            nao.setJointAngle(Joint.NECK_YAW, Math.max(-80, Math.min(80, ball.bearing())), 180);
            nao.setJointAngle(Joint.NECK_PITCH, -15, 90);
        }
    }
}
