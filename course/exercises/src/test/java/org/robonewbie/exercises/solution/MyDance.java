package org.robonewbie.exercises.solution;

import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;

/** The ball's bearing leads arms, head and knees: where it swings, the robot swings. */
public final class MyDance extends Agent {

    private static final double SWING_DEGREES = 35;

    /** Creates the solution. */
    public MyDance() {}

    @Override
    protected void think() {
        if (!fieldView.ball().isKnown()) {
            lookAround.look();
            return;
        }
        double swing = Math.max(-1, Math.min(1, fieldView.ball().bearing() / SWING_DEGREES));
        nao.setJointAngle(Joint.LEFT_SHOULDER_PITCH, 60 * swing, 200);
        nao.setJointAngle(Joint.RIGHT_SHOULDER_PITCH, -60 * swing, 200);
        nao.setJointAngle(Joint.LEFT_SHOULDER_YAW, 30 + 30 * swing, 200);
        nao.setJointAngle(Joint.RIGHT_SHOULDER_YAW, -30 + 30 * swing, 200);
        nao.setJointAngle(Joint.NECK_YAW, 40 * swing, 200);
    }
}
