package org.robonewbie.exercises.solution;

import org.robonewbie.agent.Agent;

/** Asks how the robot lies, and chooses. */
public final class GetUp extends Agent {

    /** Creates the solution. */
    public GetUp() {}

    @Override
    protected void think() {
        if (!motions.isFinished()) {
            return;
        }
        switch (nao.getBodyPosition()) {
            case LYING_ON_BACK -> motions.start("stand-up-from-back");
            case LYING_ON_FRONT -> motions.start("stand-up-from-front");
            case LYING_ON_LEFT_SIDE -> motions.start("stand-up-from-left-side");
            case LYING_ON_RIGHT_SIDE -> motions.start("stand-up-from-right-side");
            default -> {}
        }
    }
}
