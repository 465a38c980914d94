package org.robonewbie.exercises.solution;

import java.util.Locale;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.perception.CameraTransformation;
import org.robonewbie.agent.perception.FieldItem;

/** Turns what the camera sees by the pitch of the neck and then by its yaw. */
public final class BallDirection extends Agent {

    /** Creates the solution. */
    public BallDirection() {}

    @Override
    protected void think() {
        fieldView.setTransformation(CameraTransformation.KINEMATICS);
        lookAround.look();
        FieldItem ball = fieldView.ball();
        if (nao.getVision().isPresent() && ball.isVisible()) {
            nao.say(String.format(Locale.ROOT, "ball:%.1f", ball.bearing()));
        }
    }
}
