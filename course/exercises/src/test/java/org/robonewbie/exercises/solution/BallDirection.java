package org.robonewbie.exercises.solution;

import java.util.Locale;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.perception.CameraTransformation;
import org.robonewbie.agent.perception.FieldItem;
import org.robonewbie.nao.Vector3;

/** Turns what the camera sees by the neck, and then by the lean of the torso, which the accelerometer feels at rest. */
public final class BallDirection extends Agent {

    private static final double SHARE_OF_THE_NEW = 0.02;

    private double forward;
    private double up = 9.81;

    /** Creates the solution. */
    public BallDirection() {}

    @Override
    protected void think() {
        fieldView.setTransformation(CameraTransformation.KINEMATICS);
        lookAround.look();
        Vector3 felt = nao.getAcceleration();
        forward += SHARE_OF_THE_NEW * (felt.x() - forward);
        up += SHARE_OF_THE_NEW * (felt.z() - up);
        FieldItem ball = fieldView.ball();
        if (nao.getTime() > 3 && ball.isVisible()) {
            nao.say(String.format(Locale.ROOT, "ball:%.1f", bearing(ball.position(), Math.atan2(forward, up))));
        }
    }

    /** The bearing on the level ground of a point in the torso's frame. */
    private static double bearing(Vector3 point, double tilt) {
        double ahead = point.x() * Math.cos(tilt) - point.z() * Math.sin(tilt);
        return Math.toDegrees(Math.atan2(point.y(), ahead));
    }
}
