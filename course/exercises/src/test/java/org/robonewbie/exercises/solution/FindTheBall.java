package org.robonewbie.exercises.solution;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.perception.FieldItem;
import org.robonewbie.nao.Joint;

/** The head goes ahead, the feet follow by the shorter way. */
public final class FindTheBall extends Agent {

    /** Creates the solution. */
    public FindTheBall() {}

    @Override
    protected void think() {
        FieldItem ball = fieldView.ball();
        if (!ball.isKnown()) {
            lookAround.look();
            walk.towards(0, 0, 60);
            return;
        }
        if (!ball.isVisible()) {
            lookAround.look();
        } else {
            nao.setJointAngle(Joint.NECK_YAW, Math.max(-80, Math.min(80, ball.bearing())), 180);
        }
        if (ball.isVisible() && Math.abs(ball.bearing()) < 5) {
            walk.stop();
        } else {
            walk.towards(0, 0, Math.max(-60, Math.min(60, 2 * ball.bearing())));
        }
    }
}
