package org.robonewbie.exercises.solution;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.perception.CameraTransformation;
import org.robonewbie.agent.perception.FieldItem;
import org.robonewbie.nao.Joint;

/** Sideways, while the chest keeps looking at the ball. */
public final class AroundTheBall extends Agent {

    /** Creates the solution. */
    public AroundTheBall() {}

    @Override
    protected void think() {
        fieldView.setTransformation(CameraTransformation.KINEMATICS);
        FieldItem ball = fieldView.ball();
        if (nao.isFallen()) {
            motions.startGetUp();
            return;
        }
        if (ball.ageSeconds() > 1.5) {
            lookAround.look();
            walk.towards(0, 0, 30);
            return;
        }
        nao.setJointAngle(Joint.NECK_YAW, Math.max(-80, Math.min(80, ball.bearing())), 180);
        nao.setJointAngle(Joint.NECK_PITCH, -15, 90);
        double metres = ball.distance();
        walk.towards(metres - 0.6, 0.2, -18 + 1.5 * ball.bearing());
    }
}
