package org.robonewbie.learning.rehearsal;

import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.trial.Performer;

/** A robot that does what a {@link Rehearsal} says; told nothing, it holds its joints. */
interface Puppet {

    /** What moves it in a trial. */
    Performer performer();

    /** Starts a motion. */
    void play(Motion motion);

    /** Walks from now on. */
    void walk(WalkVelocity velocity);

    /** Whether it still plays a motion or walks. */
    boolean isBusy();
}
