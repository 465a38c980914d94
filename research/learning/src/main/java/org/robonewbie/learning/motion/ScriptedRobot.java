package org.robonewbie.learning.motion;

import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.trial.Controller;

/** A robot that a {@link MotionTrial} controls. Without an order it holds its joints. */
public interface ScriptedRobot {

    /** {@return the controller of the robot in a trial} */
    Controller controller();

    /**
     * Starts a motion.
     *
     * @param motion the motion
     */
    void play(Motion motion);

    /**
     * Walks from now on.
     *
     * @param velocity the velocity
     */
    void walk(WalkVelocity velocity);

    /** {@return whether it still plays a motion or walks} */
    boolean isBusy();
}
