package org.robonewbie.exercises.solution;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.perception.HeardMessage;
import org.robonewbie.nao.Joint;

/** Number 2 says on which side of number 1 the ball lies, which is the other side for itself. */
public final class TeamEyes extends Agent {

    private String side = "";

    /** Creates the solution. */
    public TeamEyes() {}

    @Override
    protected void think() {
        if (nao.getNumber() == 2) {
            nao.setJointAngle(Joint.NECK_PITCH, -10, 60);
            if (fieldView.ball().isVisible()) {
                nao.say(fieldView.ball().bearing() > 0 ? "right" : "left");
            }
            return;
        }
        for (HeardMessage message : nao.getHeard()) {
            side = message.text();
        }
        nao.setJointAngle(Joint.LEFT_SHOULDER_PITCH, side.equals("left") ? 70 : -30, 90);
        nao.setJointAngle(Joint.RIGHT_SHOULDER_PITCH, side.equals("right") ? 70 : -30, 90);
    }
}
