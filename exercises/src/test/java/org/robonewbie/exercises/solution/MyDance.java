package org.robonewbie.exercises.solution;

import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;

/** Arms and head swing while the knees bend. */
public final class MyDance extends Agent {

    /** Creates the solution. */
    public MyDance() {}

    @Override
    protected void think() {
        double swing = Math.sin(2 * Math.PI * nao.getTime() / 4);
        nao.setJointAngle(Joint.LEFT_SHOULDER_PITCH, 60 * swing, 200);
        nao.setJointAngle(Joint.RIGHT_SHOULDER_PITCH, -60 * swing, 200);
        nao.setJointAngle(Joint.LEFT_SHOULDER_YAW, 30 + 30 * swing, 200);
        nao.setJointAngle(Joint.RIGHT_SHOULDER_YAW, -30 + 30 * swing, 200);
        nao.setJointAngle(Joint.LEFT_ARM_YAW, -45 + 40 * swing, 200);
        nao.setJointAngle(Joint.LEFT_ARM_ROLL, -45 - 40 * swing, 200);
        nao.setJointAngle(Joint.RIGHT_ARM_ROLL, 45 - 40 * swing, 200);
        nao.setJointAngle(Joint.NECK_YAW, 60 * swing, 200);
        nao.setJointAngle(Joint.NECK_PITCH, 10 + 25 * swing, 200);
    }
}
