package org.robonewbie.exercises.solution;

import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;

/** The nearer the goal, the slower. */
public final class StopAt30 extends Agent {

    /** Creates the solution. */
    public StopAt30() {}

    @Override
    protected void think() {
        double way = 30 - nao.getJointAngle(Joint.LEFT_SHOULDER_PITCH);
        nao.setJointSpeed(Joint.LEFT_SHOULDER_PITCH, Math.max(-100, Math.min(100, 5 * way)));
    }
}
