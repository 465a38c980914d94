package org.robonewbie.competition.programs;

import org.robonewbie.agent.Agent;

/** Plays for two seconds, then does something that it should not. */
abstract class Misbehaving extends Agent {

    private static final double GOOD_SECONDS = 2;

    @Override
    protected final void think() {
        motions.start("walk-forward");
        if (nao.getTime() > GOOD_SECONDS) {
            misbehave();
        }
    }

    /** Does it. */
    protected abstract void misbehave();
}
