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
 * Thinks with a world model of its own in the place of the local field view: it foresees where the ball is while the robot moves and the
 * head looks elsewhere, and draws that on the pitch (orange) beside what the field view remembers (grey).
 *
 * <p>A world model is any class that is updated in {@link #sense}, after the framework has read all sensors: that one line is all that is
 * needed. Kick the ball in the studio and see how long the two circles agree.
 *
 * <p>Ideas: let the ball slow down as it rolls; forget it when the camera looks where it should be and sees none; ask team mates.
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

    /** Where the ball is, as the robot moves on and the ball rolls. */
    private static final class WorldModel {

        private static final double TRUST_IN_THE_NEW = 0.3;

        private final Odometry odometry = new Odometry();
        private Vector3 place = Vector3.ZERO;
        private Vector3 velocity = Vector3.ZERO;
        private double seenSeconds = Double.NEGATIVE_INFINITY;

        /** Takes in one cycle: the robot's own motion, and the ball if it is seen. */
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
                velocity = velocity.times(1 - TRUST_IN_THE_NEW).plus(measured.times(TRUST_IN_THE_NEW));
            } else {
                velocity = Vector3.ZERO;
            }
            place = now;
            seenSeconds = ball.lastSeenSeconds();
        }

        /** The ball as seen from the robot, at a time. */
        Vector3 ball(double seconds) {
            return odometry.pose().fromFrame(place.plus(velocity.times(seconds - seenSeconds)));
        }
    }
}
