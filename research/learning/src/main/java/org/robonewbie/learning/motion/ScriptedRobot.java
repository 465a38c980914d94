package org.robonewbie.learning.motion;

import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.trial.Controller;

/** Robot controlled by a {@link MotionTrial}. It holds its joints still unless it is playing a motion or walking. */
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
     * Sets the walk velocity.
     *
     * @param velocity the velocity; zero to stop
     */
    void walk(WalkVelocity velocity);

    /** {@return whether the robot is playing a motion or walking} */
    boolean isBusy();
}
