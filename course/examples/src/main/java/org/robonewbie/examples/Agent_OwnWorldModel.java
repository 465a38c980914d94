package org.robonewbie.examples;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.Options;
import org.robonewbie.agent.Robot;
import org.robonewbie.agent.localisation.Odometry;
import org.robonewbie.agent.perception.CameraTransformation;
import org.robonewbie.agent.perception.FieldItem;
import org.robonewbie.agent.perception.LocalFieldView;
import org.robonewbie.nao.Vector3;

/**
 * An agent with its own world model instead of the local field view: it predicts the ball while the robot moves or its head is
 * turned away, and draws the prediction (orange) beside the field view's memory (grey).
 *
 * <p>A world model can be any class. One line in {@link #sense} updates it after the framework has read all sensors. Kick the
 * ball in the studio and watch how long the two circles agree.
 *
 * <p>Ideas: model the friction of the ball; discard the ball's position when it should be in view but is not detected; ask
 * teammates.
 */
public final class Agent_OwnWorldModel extends Agent {

    private final WorldModel world = new WorldModel();

    /** Creates the agent. */
    public Agent_OwnWorldModel() {
        fieldView.setTransformation(CameraTransformation.KINEMATICS);
    }

    /**
     * Starts the robot.
     *
     * @param args options such as {@code --headless}; {@code --help} lists them
     */
    public static void main(String[] args) {
        new Agent_OwnWorldModel().run(args);
    }

    @Override
    protected Options defaults() {
        return Options.none().withPose(-2, 0.5, 0);
    }

    @Override
    protected void sense() {
        super.sense();
        world.update(nao, fieldView);
    }

    @Override
    protected void think() {
        lookAround.look();
        walk.towards(0.1, 0, 10);
        if (fieldView.ball().isKnown()) {
            nao.drawCircle(fieldView.ball().position(), 0.1, "grey");
            nao.drawCircle(world.ball(nao.getTime()), 0.15, "orange");
        }
    }

    /** Estimates the ball's position while both the robot and the ball move. */
    private static final class WorldModel {

        private static final double SMOOTHING = 0.3;

        private final Odometry odometry = new Odometry();
        private Vector3 place = Vector3.ZERO;
        private Vector3 velocity = Vector3.ZERO;
        private double seenSeconds = Double.NEGATIVE_INFINITY;

        /** Updates the model for one cycle with the robot's movement and, if the ball is visible, its position. */
        void update(Robot nao, LocalFieldView seen) {
            odometry.update(nao);
            FieldItem ball = seen.ball();
            if (ball.isVisible() && ball.lastSeenSeconds() > seenSeconds) {
                see(ball, odometry.pose().toFrame(ball.position()));
            }
        }

        private void see(FieldItem ball, Vector3 now) {
            double seconds = ball.lastSeenSeconds() - seenSeconds;
            if (seconds < 1) {
                Vector3 measured = now.minus(place).times(1 / seconds);
                velocity = velocity.times(1 - SMOOTHING).plus(measured.times(SMOOTHING));
            } else {
                velocity = Vector3.ZERO;
            }
            place = now;
            seenSeconds = ball.lastSeenSeconds();
        }

        /** Returns the predicted position of the ball in the robot's frame. */
        Vector3 ball(double seconds) {
            return odometry.pose().fromFrame(place.plus(velocity.times(seconds - seenSeconds)));
        }
    }
}
