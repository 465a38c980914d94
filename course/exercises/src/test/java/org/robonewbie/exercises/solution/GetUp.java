package org.robonewbie.exercises.solution;

import org.robonewbie.agent.Agent;

/** Asks how the robot lies, says it, and chooses; says when it stands. */
public final class GetUp extends Agent {

    private boolean wasFallen;

    /** Creates the solution. */
    public GetUp() {}

    @Override
    protected void think() {
        wasFallen |= nao.isFallen();
        if (!motions.isFinished()) {
            return;
        }
        switch (nao.getBodyPosition()) {
            case LYING_ON_BACK -> getUp("back", "stand-up-from-back");
            case LYING_ON_FRONT -> getUp("front", "stand-up-from-front");
            case LYING_ON_LEFT_SIDE -> getUp("left", "stand-up-from-left-side");
            case LYING_ON_RIGHT_SIDE -> getUp("right", "stand-up-from-right-side");
            default -> {
                if (wasFallen) {
                    nao.say("up");
                }
            }
        }
    }

    private void getUp(String side, String motion) {
        nao.say(side);
        motions.start(motion);
    }
}
