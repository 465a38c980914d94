package org.robonewbie.exercises;

import org.robonewbie.agent.Agent;
import org.robonewbie.nao.motion.Motion;

/** A robot without a will of its own, which an exercise moves. */
public final class Puppet extends Agent {

    /** Creates a robot that holds still. */
    public Puppet() {}

    void play(String motion) {
        motions.start(motion);
    }

    void play(Motion motion) {
        motions.start(motion);
    }

    boolean isFinished() {
        return motions.isFinished();
    }
}
