package org.robonewbie.exercises.solution;

import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;

/** Two behaviours with joints of their own. */
public final class TwoBehaviours extends Agent {

    /** Creates the solution. */
    public TwoBehaviours() {}

    @Override
    protected void think() {
        followTheBall();
        swingTheArm();
    }

    private void followTheBall() {
        if (fieldView.ball().isKnown()) {
            double bearing = fieldView.ball().bearing();
            nao.setJointAngle(Joint.NECK_YAW, Math.max(-100, Math.min(100, bearing)), 120);
        } else {
            lookAround.look();
        }
    }

    private void swingTheArm() {
        nao.setJointAngle(Joint.LEFT_SHOULDER_PITCH, 45 * Math.sin(2 * Math.PI * nao.getTime() / 2), 300);
    }
}
