package org.robonewbie.exercises.solution;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.perception.PlayerItem;
import org.robonewbie.nao.Joint;

/** Asks each robot that is seen for its side. */
public final class ArmBySide extends Agent {

    /** Creates the solution. */
    public ArmBySide() {}

    @Override
    protected void think() {
        boolean left = false;
        boolean right = false;
        for (PlayerItem player : fieldView.players()) {
            if (player.isVisible()) {
                left |= player.bearing() > 0;
                right |= player.bearing() < 0;
            }
        }
        nao.setJointAngle(Joint.LEFT_SHOULDER_PITCH, left ? 90 : 0, 150);
        nao.setJointAngle(Joint.RIGHT_SHOULDER_PITCH, right ? 90 : 0, 150);
    }
}
