package org.robonewbie.learning.rehearsal;

import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.trial.Controller;

/** A robot that does what a {@link Rehearsal} says; told nothing, it holds its joints. */
public interface Puppet {

    /** {@return what moves it in a trial} */
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
