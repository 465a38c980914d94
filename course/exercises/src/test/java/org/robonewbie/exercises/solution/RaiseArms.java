package org.robonewbie.exercises.solution;

import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;

/** Two joints, two goals; slow enough to be exact. */
public final class RaiseArms extends Agent {

    /** Creates the solution. */
    public RaiseArms() {}

    @Override
    protected void think() {
        raise(Joint.LEFT_SHOULDER_PITCH, 60);
        raise(Joint.RIGHT_SHOULDER_PITCH, 45);
    }

    private void raise(Joint joint, double goal) {
        nao.setJointSpeed(joint, nao.getJointAngle(joint) < goal ? 30 : 0);
    }
}
