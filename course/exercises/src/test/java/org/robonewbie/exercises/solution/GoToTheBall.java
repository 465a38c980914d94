package org.robonewbie.exercises.solution;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.perception.CameraTransformation;
import org.robonewbie.agent.perception.FieldItem;
import org.robonewbie.nao.Joint;

/** A hierarchy of deciders: search, approach, celebrate. */
public final class GoToTheBall extends Agent {

    /** Creates the solution. */
    public GoToTheBall() {}

    private boolean arrived;

    @Override
    protected void think() {
        fieldView.setTransformation(CameraTransformation.KINEMATICS);
        FieldItem ball = fieldView.ball();
        if (nao.isFallen()) {
            motions.startGetUp();
        } else if (arrived) {
            celebrate();
        } else if (ball.ageSeconds() < 1.5) {
            approach(ball);
        } else {
            lookAround.look();
            walk.towards(0, 0, 40);
        }
    }

    private void approach(FieldItem ball) {
        nao.setJointAngle(Joint.NECK_YAW, Math.max(-80, Math.min(80, ball.bearing())), 180);
        nao.setJointAngle(Joint.NECK_PITCH, -25, 90);
        double ground = ball.distance();
        if (ground < 0.42 && Math.abs(ball.bearing()) < 10) {
            walk.stop();
            arrived = true;
        } else {
            double speed = Math.abs(ball.bearing()) < 30 ? Math.max(-0.1, Math.min(0.4, ground - 0.38)) : 0;
            walk.towards(speed, 0, 1.5 * ball.bearing());
        }
    }

    private void celebrate() {
        if (!walk.isWalking()) {
            nao.setJointAngle(Joint.LEFT_SHOULDER_PITCH, 90, 100);
        }
    }
}
