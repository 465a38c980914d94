package org.robonewbie.exercises.solution;

import org.robonewbie.agent.Agent;

/** Plays a kick that a search has found; the worksheet wants one of your own. */
public final class Kick extends Agent {

    /** Creates the solution. */
    public Kick() {}

    private boolean kicked;

    @Override
    protected void think() {
        if (!kicked) {
            kicked = motions.start("kick-left");
        }
    }
}
