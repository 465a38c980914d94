package org.robonewbie.exercises.solution;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.perception.FieldItem;
import org.robonewbie.nao.Joint;

/** Number 2 waits for the ball to roll and walks to it. */
public final class Passing extends Agent {

    /** Creates the solution. */
    public Passing() {}

    private boolean passed;
    private double firstDistance;

    @Override
    protected void think() {
        if (nao.getNumber() == 1) {
            if (!passed) {
                passed = motions.start("pass-left");
            }
            return;
        }
        FieldItem ball = fieldView.ball();
        if (ball.ageSeconds() > 1) {
            lookAround.look();
            return;
        }
        nao.setJointAngle(Joint.NECK_YAW, Math.max(-80, Math.min(80, ball.bearing())), 180);
        firstDistance = Math.max(firstDistance, ball.distance());
        if (ball.distance() < firstDistance - 0.7 && ball.distance() > 0.3) {
            walk.towards(Math.abs(ball.bearing()) < 40 ? 0.3 : 0, 0, 1.5 * ball.bearing());
        } else {
            walk.stop();
        }
    }
}
