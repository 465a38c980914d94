package org.robonewbie.exercises.solution;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.perception.CameraTransformation;
import org.robonewbie.agent.perception.FieldItem;
import org.robonewbie.nao.Vector3;

/** Two pictures tell the speed of the ball and where it passes; after a dive the robot gets up for the next shot. */
public final class Goalkeeper extends Agent {

    /** Creates the solution. */
    public Goalkeeper() {}

    private double pictureSeconds;
    private Vector3 before = Vector3.ZERO;

    @Override
    protected void think() {
        fieldView.setTransformation(CameraTransformation.KINEMATICS);
        FieldItem ball = fieldView.ball();
        if (nao.isFallen() && motions.isFinished()) {
            motions.startGetUp();
        } else if (nao.getVision().isPresent() && ball.isVisible()) {
            watch(ball.position());
        }
    }

    private void watch(Vector3 now) {
        double seconds = nao.getTime() - pictureSeconds;
        double approach = (before.x() - now.x()) / seconds;
        if (seconds < 0.5 && approach > 1 && now.x() / approach < 1.3) {
            double crossing = now.y() + (now.y() - before.y()) / seconds * now.x() / approach;
            if (motions.isFinished() && Math.abs(crossing) > 0.08) {
                motions.start(crossing > 0 ? "dive-left" : "dive-right");
            }
        }
        if (seconds > 0.25) {
            before = now;
            pictureSeconds = nao.getTime();
        }
    }
}
